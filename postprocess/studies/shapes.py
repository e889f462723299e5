#!/usr/bin/env python3
"""One sheet of pictures that `taut render` has drawn.

Usage: shapes.py [--bars] OUTPUT.png COLUMNS PICTURE.png...
Colour bars are cut off but for those of the last row, or kept by --bars.
"""

import argparse

from PIL import Image

# Of the height: what a picture holds above its colour bar.
ABOVE_BAR = 0.8
WIDTH = 1300  # of the sheet, in pixels
COLOURS = 256


def compose(files, columns, has_bars):
    pictures = [Image.open(file).convert("RGB") for file in files]
    wide, high = pictures[0].size
    above = high if has_bars else round(ABOVE_BAR * high)
    rows = -(-len(pictures) // columns)
    sheet = Image.new("RGB", (columns * wide, (rows - 1) * above + high),
                      "white")
    for place, picture in enumerate(pictures):
        row, column = divmod(place, columns)
        if row < rows - 1:
            picture = picture.crop((0, 0, wide, above))
        sheet.paste(picture, (column * wide, row * above))
    size = (WIDTH, round(sheet.height * WIDTH / sheet.width))
    return sheet.resize(size, Image.LANCZOS)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bars", action="store_true")
    parser.add_argument("output")
    parser.add_argument("columns", type=int)
    parser.add_argument("pictures", nargs="+")
    words = parser.parse_args()
    sheet = compose(words.pictures, words.columns, words.bars)
    sheet.quantize(COLOURS).save(words.output, optimize=True)


if __name__ == "__main__":
    main()
