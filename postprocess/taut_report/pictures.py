"""Pictures of a folder as part of the page."""

import base64
import io
import json

from . import markup
from .markup import section, tag

TYPES = {".png": "image/png", ".svg": "image/svg+xml", ".webp": "image/webp",
         ".mp4": "video/mp4"}
# A drawn plot that is larger is shown as its PNG.
LARGEST_SVG = 400_000


def encode(data, suffix):
    text = base64.b64encode(data).decode("ascii")
    return f"data:{TYPES[suffix]};base64,{text}"


def make_address(file):
    """A data URI; of a PNG a smaller WebP if Pillow is there."""
    if file.suffix == ".png":
        try:
            from PIL import Image
        except ImportError:
            return encode(file.read_bytes(), ".png")
        packed = io.BytesIO()
        with Image.open(file) as picture:
            picture.convert("RGB").save(packed, "WEBP", quality=88, method=6)
        return encode(packed.getvalue(), ".webp")
    return encode(file.read_bytes(), file.suffix)


def make_still(folder, still, title):
    name = still["name"]
    return tag("figure", tag("img", src=make_address(folder / still["file"]),
                             alt=f"The device, {name}, coloured by {title}",
                             loading="lazy"),
               tag("figcaption", name))


def make_animation(folder, animation, stills, title):
    file = folder / animation["file"]
    alt = f"Animation of the device, coloured by {title}"
    if file.suffix == ".mp4":
        poster = (make_address(folder / stills[-1]["file"]) if stills
                  else None)
        shown = tag("video", src=make_address(file), controls=True, loop=True,
                    muted=True, playsinline=True, poster=poster,
                    aria_label=alt)
    else:
        still = tag("source", media="(prefers-reduced-motion: reduce)",
                    srcset=make_address(folder / stills[-1]["file"]))
        shown = tag("picture", still, tag("img", src=make_address(file),
                                          alt=alt))
    return tag("figure", shown, class_="wide")


def describe(written):
    """Caption: field, range, and where colours end."""
    title, unit = written["title"], written["unit"]
    if written["field"] == "mode":
        return tag("p", "Shapes of the modes, each drawn at the same largest "
                        "excursion; outline: the mesh.")
    low, high = (markup.quantity(x, unit) for x in written["range"])
    words = [f"Coloured by {title}, from ", low, " to ", high]
    if written["limits"] != written["range"]:
        a, b = (markup.quantity(x, unit) for x in written["limits"])
        words += ["; the colours span ", a, " to ", b,
                  ", since a few places (corners) go beyond"]
    return tag("p", words, ". Outline: the film in the mesh.")


def make_pictures(results, problem):
    """What `taut render` has drawn, or why there is nothing."""
    folder = results.folder / "pictures"
    list_file = folder / "pictures.json"
    if not list_file.is_file():
        return section("pictures", "Pictures",
                       tag("p", problem) if problem else None)
    written = json.loads(list_file.read_text(encoding="utf-8"))
    stills = written["stills"]
    parts = [describe(written)]
    if "animation" in written:
        parts.append(make_animation(folder, written["animation"], stills,
                                    written["title"]))
    parts.append(tag("div", [make_still(folder, still, written["title"])
                             for still in stills], class_="pictures"))
    return section("pictures", "Pictures", parts)


def make_plots(folder):
    """The plots that a study's own script has drawn."""
    stems = sorted({file.stem for file in folder.iterdir()
                    if file.suffix in (".svg", ".png")})
    figures = []
    for stem in stems:
        drawn, pixels = folder / f"{stem}.svg", folder / f"{stem}.png"
        use_svg = drawn.is_file() and (drawn.stat().st_size < LARGEST_SVG
                                       or not pixels.is_file())
        figures.append(tag(
            "figure", tag("img", src=make_address(drawn if use_svg else pixels),
                          alt=f"Plot {stem}", loading="lazy"),
            tag("figcaption", stem.replace("_", " "))))
    return tag("div", figures, class_="pictures") if figures else None
