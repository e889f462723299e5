"""The colour bar and the words in a picture."""

from dataclasses import dataclass
from pathlib import Path

import matplotlib
from PIL import Image, ImageDraw, ImageFont

import taut_numbers as numbers

INK, SOFT_INK = (28, 30, 34), (90, 94, 100)
COLOUR_MAP = "viridis"


@dataclass
class ColourBar:
    """Title with unit, ends of the colours, whole range of the field."""

    title: str
    unit: str
    limits: tuple
    whole: tuple


def load_font(size):
    folder = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
    return ImageFont.truetype(str(folder / "DejaVuSans.ttf"), round(size))


def make_gradient(width, height):
    colours = matplotlib.colormaps[COLOUR_MAP]
    row = Image.new("RGB", (width, 1))
    row.putdata([tuple(round(255 * c) for c in colours(x / (width - 1))[:3])
                 for x in range(width)])
    return row.resize((width, height))


def draw_bar(picture, box, bar):
    """Pointed where the field goes beyond the colours."""
    left, top, right, bottom = box
    picture.paste(make_gradient(right - left, bottom - top), (left, top))
    canvas = ImageDraw.Draw(picture)
    colours = matplotlib.colormaps[COLOUR_MAP]
    point, middle = round(0.6 * (bottom - top)), (top + bottom) / 2
    slack = 1e-6 * (bar.limits[1] - bar.limits[0])
    if bar.whole[0] < bar.limits[0] - slack:
        canvas.polygon([(left, top), (left, bottom - 1), (left - point, middle)],
                       fill=tuple(round(255 * c) for c in colours(0.0)[:3]))
    if bar.whole[1] > bar.limits[1] + slack:
        canvas.polygon([(right - 1, top), (right - 1, bottom - 1),
                        (right - 1 + point, middle)],
                       fill=tuple(round(255 * c) for c in colours(1.0)[:3]))


def draw_ticks(canvas, box, bar, font):
    left, _, right, bottom = box
    scale = numbers.choose_scale(bar.unit, bar.limits)
    low, high = (limit * scale.factor for limit in bar.limits)
    for value, text in numbers.make_ticks(low, high, 5):
        x = left + (value - low) / (high - low) * (right - left)
        canvas.line([(x, bottom), (x, bottom + 0.3 * font.size)], fill=INK,
                    width=max(1, round(font.size / 14)))
        canvas.text((x, bottom + 0.45 * font.size), text, font=font, fill=INK,
                    anchor="mt")


def draw_colour_bar(picture, bar):
    width, height = picture.size
    font = load_font(min(height / 26, width / 32))
    thick = round(0.8 * font.size)
    top = height - round(3.1 * font.size)
    box = (round(0.22 * width), top, round(0.78 * width), top + thick)
    canvas = ImageDraw.Draw(picture)
    scale = numbers.choose_scale(bar.unit, bar.limits)
    canvas.text((width / 2, top - 0.45 * font.size),
                numbers.make_label(bar.title, scale.unit), font=font, fill=INK,
                anchor="mb")
    draw_bar(picture, box, bar)
    draw_ticks(canvas, box, bar, font)


def finish(raw, size, text, bar, file):
    """Reduces what ParaView has drawn and writes the words."""
    with Image.open(raw) as drawn:
        picture = drawn.convert("RGB").resize(size, Image.Resampling.LANCZOS)
    draw_colour_bar(picture, bar)
    font = load_font(min(size[1] / 26, size[0] / 32))
    ImageDraw.Draw(picture).text((font.size, font.size), text, font=font,
                                 fill=INK, anchor="lt")
    picture.save(file, compress_level=1)


def shrink(file, small):
    """The same picture in fewer bytes, which takes a while."""
    with Image.open(file) as picture:
        picture.save(small, optimize=True)
