#!/usr/bin/env python3
"""Pictures and an animation of a run, drawn by ParaView without a screen; this
is what `taut render` calls.

Writes into DIR/pictures (or --output) still_*.png, with --animation also
animation.mp4 (animation.webp without ffmpeg), and pictures.json, which says what
they show; and DIR/open_in_paraview.py, a script that shows the same in ParaView.
"""

import argparse
import json
import math
import sys
import tempfile
from pathlib import Path

from taut_render import animation, camera, frames, labels, paraview_call
from taut_render import session
from taut_render.refusal import Refusal

N_STILLS, MOST_MODES, MOST_SHOTS, SHOTS_OF_MODE = 4, 12, 100, 32


def parse_size(text):
    try:
        width, height = (int(x) for x in text.lower().split("x"))
    except ValueError:
        width = height = 0
    if not (200 <= width <= 8000 and 200 <= height <= 8000):
        raise Refusal(f"the size '{text}' is not of the form 1200x800, with "
                      "200 to 8000 each")
    return width, height


def check_view(view):
    try:
        if view != "auto":
            camera.find_direction(view)
    except ValueError:
        raise Refusal(f"there is no view '{view}'; there are auto, "
                      f"{', '.join(camera.VIEWS)}, and azimuth,elevation in "
                      "degrees such as 30,20") from None
    return view


def parse_times(text, found):
    """The frames nearest to the times of a list."""
    try:
        wanted = [float(x) for x in text.split(",")]
    except ValueError:
        raise Refusal(f"--times '{text}' is not a list of times such as "
                      "0, 0.1, 0.5") from None
    low, high = min(found.times), max(found.times)
    slack = 0.5 * (high - low) / max(len(found.times) - 1, 1)
    for time in wanted:
        if not low - slack <= time <= high + slack:
            raise Refusal(f"--times {time:g} is outside the run, whose frames "
                          f"are from {low:g} to {high:g}")
    return sorted({found.find_nearest(time) for time in wanted})


def thin(frames_, count):
    """`count` of the frames, evenly, the first and the last among them."""
    if count >= len(frames_):
        return list(frames_)
    if count == 1:
        return [frames_[-1]]
    last = len(frames_) - 1
    return [frames_[round(i * last / (count - 1))] for i in range(count)]


def choose_frames(arguments, found):
    """The stills, as numbers of frames."""
    everything = range(len(found.times))
    if arguments.times:
        return parse_times(arguments.times, found)
    if arguments.frames is not None and arguments.frames < 1:
        raise Refusal("--frames is a number of 1 or more")
    if found.is_modes:
        modes = [i for i in everything if found.times[i] > 0]
        return (modes or list(everything))[:arguments.frames or MOST_MODES]
    return thin(everything, arguments.frames or N_STILLS)


def make_shot(found, frame, share):
    """`share` of the shape of a mode, -1 to 1."""
    return {"time": found.keys[frame], "share": share,
            "name": found.names[frame]}


def plan_animation(arguments, found):
    """A run from its beginning to its end, or a period of one mode."""
    if not arguments.animation:
        return []
    if not found.is_modes:
        return [make_shot(found, frame, 0)
                for frame in thin(range(len(found.times)), MOST_SHOTS)]
    if arguments.mode not in found.times:
        raise Refusal(f"there is no mode {arguments.mode}; there are 1 to "
                      f"{max(found.times):.0f}")
    frame = found.find_nearest(arguments.mode)
    return [make_shot(found, frame, math.sin(2 * math.pi * i / SHOTS_OF_MODE))
            for i in range(SHOTS_OF_MODE)]


def draw_shots(plan, shots, bar, work):
    """Draws into `work`; the colour bar and the finished files."""
    for place, shot in enumerate(shots):
        shot["file"] = str(work / f"raw_{place:04d}.png")
    facts = paraview_call.draw({**plan, "shots": shots})
    if plan["field"] == "mode":
        facts = {"limits": [0, 1], "range": [0, 1]}
    bar = labels.ColourBar(*bar, facts["limits"], facts["range"])
    files = []
    for place, shot in enumerate(shots):
        files.append(work / f"shot_{place:04d}.png")
        labels.finish(shot["file"], tuple(plan["size"]), shot["name"], bar,
                      files[-1])
        Path(shot["file"]).unlink()
    return bar, files


def clear(folder):
    """What an earlier call has left."""
    for pattern in ("still_*.png", "animation.*", "pictures.json"):
        for file in folder.glob(pattern):
            file.unlink()


def write_pictures(arguments, found, field):
    output = Path(arguments.output or Path(arguments.folder) / "pictures")
    chosen = choose_frames(arguments, found)
    stills = [make_shot(found, frame, 1 if found.is_modes else 0)
              for frame in chosen]
    moving = plan_animation(arguments, found)
    plan = {"source": str(found.source.resolve()), "field": field,
            "size": parse_size(arguments.size),
            "view": check_view(arguments.view)}
    paraview_call.check_paraview()
    # A mode has no size of its own.
    bar = (frames.get_title(field),
           "" if field == "mode" else found.units[field])
    output.mkdir(parents=True, exist_ok=True)
    clear(output)
    written = {"field": field, "title": bar[0], "unit": bar[1], "stills": []}
    with tempfile.TemporaryDirectory(prefix="taut_render_") as folder:
        work = Path(folder)
        # All at once: one camera and one range for stills and animation.
        bar, files = draw_shots(plan, moving + stills, bar, work)
        for place, shot in enumerate(stills):
            name = f"still_{place:02d}.png"
            labels.shrink(files[len(moving) + place], output / name)
            written["stills"].append({"file": name, "name": shot["name"],
                                      "time": found.times[chosen[place]]})
        if moving:
            made = animation.write_animation(work, len(moving),
                                             output / "animation")
            written["animation"] = {"file": made.name,
                                    "frames": len(moving)}
    written.update(limits=list(bar.limits), range=list(bar.whole))
    (output / "pictures.json").write_text(json.dumps(written, indent=2) + "\n",
                                          encoding="utf-8")
    return output, written


def render(arguments):
    found = frames.read_frames(arguments.folder)
    field = (frames.check_field(found, arguments.field) if arguments.field
             else frames.choose_field(found, arguments.folder))
    output, written = write_pictures(arguments, found, field)
    script = session.write_session(Path(arguments.folder), found, field,
                                   written["limits"])
    names = [still["file"] for still in written["stills"]]
    if "animation" in written:
        names.append(written["animation"]["file"])
    print(f"{len(names)} pictures of {written['title']} in {output}: "
          f"{', '.join(names)}")
    print(f"the same by hand: paraview --script={script}")


def parse_words(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("--field")
    parser.add_argument("--times")
    parser.add_argument("--frames", type=int)
    parser.add_argument("--animation", action="store_true")
    parser.add_argument("--mode", type=int, default=1)
    parser.add_argument("--size", default="1200x800")
    parser.add_argument("--view", default="auto")
    parser.add_argument("-o", "--output")
    return parser.parse_args(words)


def main(words):
    try:
        render(parse_words(words))
    except Refusal as refusal:
        print(f"taut: {refusal}", file=sys.stderr)
        return 2
    except (RuntimeError, OSError) as error:
        print(f"taut: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
