"""Animations: MP4 by ffmpeg, which every player knows, or else WebP by Pillow,
which every browser knows."""

import shutil
import subprocess

from PIL import Image

from .refusal import Refusal


def choose_rate(count):
    """Pictures a second: six seconds if that is neither slow nor fast."""
    return min(max(round(count / 6), 4), 25)


def write_mp4(pictures, count, rate, file):
    """`pictures`: files named by a pattern such as shot_%04d.png, of which the
    first `count` are taken."""
    # Most players want even sizes and this kind of colour.
    words = ["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(rate),
             "-i", str(pictures), "-frames:v", str(count), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2",
             "-c:v", "libx264", "-crf", "20", "-preset", "medium", "-pix_fmt",
             "yuv420p", "-movflags", "+faststart", str(file)]
    done = subprocess.run(words, capture_output=True, text=True,
                          stdin=subprocess.DEVNULL, check=False)
    if done.returncode:
        raise Refusal(f"ffmpeg made no animation: {done.stderr.strip()}")


def write_webp(pictures, rate, file):
    images = [Image.open(picture) for picture in pictures]
    images[0].save(file, save_all=True, append_images=images[1:], loop=0,
                   duration=round(1000 / rate), quality=80, method=4)


def write_animation(folder, count, stem, rate=None):
    """Of shot_0000.png and so on in `folder`; the file that was written."""
    rate = rate or choose_rate(count)
    for suffix in (".mp4", ".webp"):
        stem.with_suffix(suffix).unlink(missing_ok=True)
    if shutil.which("ffmpeg"):
        file = stem.with_suffix(".mp4")
        write_mp4(folder / "shot_%04d.png", count, rate, file)
    else:
        file = stem.with_suffix(".webp")
        write_webp([folder / f"shot_{i:04d}.png" for i in range(count)], rate,
                   file)
    return file
