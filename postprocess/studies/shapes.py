#!/usr/bin/env python3
"""One sheet of the pictures that `taut render` has drawn of a run.

Usage: shapes.py FOLDER OUTPUT.png COLUMNS [FIRST LAST]
FOLDER holds `pictures`; FIRST and LAST are numbers of pictures, from 0. The
colour bars below are cut off but for that of the last row.
"""

import sys
from pathlib import Path

from PIL import Image

# Of the height: what a picture holds above its colour bar.
ABOVE_BAR = 0.8
WIDTH = 1300  # of the sheet, in pixels
COLOURS = 256


def compose(files, columns):
    pictures = [Image.open(file).convert("RGB") for file in files]
    wide, high = pictures[0].size
    above = round(ABOVE_BAR * high)
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
    if len(sys.argv) not in (4, 6):
        raise SystemExit(__doc__)
    files = sorted((Path(sys.argv[1]) / "pictures").glob("still_*.png"))
    if len(sys.argv) == 6:
        files = files[int(sys.argv[4]):int(sys.argv[5]) + 1]
    if not files:
        raise SystemExit(f"no pictures in {sys.argv[1]}: call taut render "
                         "first")
    sheet = compose(files, int(sys.argv[3]))
    sheet.quantize(COLOURS).save(sys.argv[2],
                                optimize=True)


if __name__ == "__main__":
    main()
