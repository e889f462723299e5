"""Pixels of pictures, read with Pillow, which comes with Matplotlib."""

import json
import subprocess
import sys

SCRIPT = """
import json, sys
from PIL import Image
with Image.open(sys.argv[1]) as image:
    frames = getattr(image, "n_frames", 1)
    rgb = image.convert("RGB")
    sys.stdout.buffer.write(json.dumps([*rgb.size, frames]).encode() + b"\\n")
    sys.stdout.buffer.write(rgb.tobytes())
"""


def find_python():
    """As the program does: the one that has Matplotlib."""
    for python in (sys.executable, "python3", "/usr/bin/python3"):
        done = subprocess.run([python, "-c", "import PIL, matplotlib"],
                              capture_output=True, check=False)
        if done.returncode == 0:
            return python
    raise AssertionError("there is no python3 with matplotlib")


class Picture:
    def __init__(self, file):
        done = subprocess.run([find_python(), "-c", SCRIPT, str(file)],
                              capture_output=True, check=True)
        head, _, self.data = done.stdout.partition(b"\n")
        self.width, self.height, self.frames = json.loads(head)

    def get(self, x, y):
        """Red, green and blue at shares of width and height."""
        place = 3 * (int(y * self.height) * self.width + int(x * self.width))
        return tuple(self.data[place:place + 3])

    def get_rows(self, first, last):
        """The bytes of the rows between two shares of the height."""
        a, b = (int(y * self.height) * 3 * self.width for y in (first, last))
        return self.data[a:b]

    def find_edge_colours(self):
        """All colours on the edge of the picture."""
        width, height = self.width, self.height
        places = [x for x in range(width)]
        places += [(height - 1) * width + x for x in range(width)]
        places += [y * width for y in range(height)]
        places += [y * width + width - 1 for y in range(height)]
        return {tuple(self.data[3 * p:3 * p + 3]) for p in places}
