#!/usr/bin/env python3
"""Studies of what lumped models cannot show, reduced to a few cases.

Usage: studies_space_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import math
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1:3]
STUDIES = Path(SOURCE) / "prm" / "studies"


def find_wave_number(ratio):
    """Lowest root of z tan z = 2/ratio."""
    low, high = 0.0, math.pi / 2
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle * math.tan(middle) * ratio < 2:
            low = middle
        else:
            high = middle
    return low


class Studies(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut studies "))
        self.addCleanup(shutil.rmtree, self.folder)

    def call(self, *words):
        done = subprocess.run([PROGRAM, "study", *words],
                              capture_output=True, text=True, timeout=120,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def run_study(self, name, **values):
        """Rows of the table, without the plot."""
        words = ["Plot ="]
        words += [f"Vary {key}/Values = {text}"
                  for key, text in values.items()]
        output = self.folder / name
        self.call(STUDIES / f"{name}.prm", "-o", output, "--jobs", "1",
                  "--set", *words)
        with open(output / "study.csv", newline="",
                  encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def get_frequencies(self, name, **values):
        return [float(row["frequency [Hz]"])
                for row in self.run_study(name, **values)]

    def test_every_study_is_complete(self):
        for file in sorted(STUDIES.glob("*.prm")):
            if "set Case" in file.read_text(encoding="utf-8"):
                cases = self.call(file, "--dry-run").splitlines()
                self.assertGreater(len(cases), 1, file)

    def test_ideal_supports_are_lumped_and_clamped_sides_are_stiffer(self):
        lumped, = self.get_frequencies("frequency_lumped", p1="2", p2="4",
                                       kilovolts="0")
        # 20 g over the 0.384 g of a strip.
        ideal, = self.get_frequencies("frequency_wave", ratio=f"{20 / .384!r}",
                                      cells="1")
        # The lumped networks are relaxed up to their tolerance, the ramp of the
        # film ends at 1 V.
        self.assertAlmostEqual(ideal / lumped, 1, delta=1e-6)
        near, far = self.get_frequencies("frequency_clamped", ratio="2, 4",
                                         p1="2", p2="4", kilovolts="0")
        # The sides of a strip that is twice as wide hold half as much.
        self.assertGreater(far, 1.1 * lumped)
        self.assertAlmostEqual((near - lumped) / (far - lumped), 2, delta=.3)

    def test_film_of_one_cell_misses_its_waves(self):
        lumped, wave = self.get_frequencies("frequency_wave", ratio="1",
                                            cells="1, 12")
        exact = math.sqrt(2 / (1 + 2 / 3)) / find_wave_number(1)
        # 12 quadratic cells: (z/12)^4/720 of a frequency.
        self.assertAlmostEqual(lumped / wave, exact, delta=1e-6)

    def test_clamped_film_loses_tension_before_the_lumped_strips(self):
        failed, = self.run_study("clamped_failure", ratio="2", p1="2", p2="4",
                                 refined="1")
        self.assertEqual(failed["status"], "event")
        # The bare minimum is in the other strip, beyond the bar at 40 mm.
        events = (self.folder / "clamped_failure" / failed["folder"]
                  / "events.csv")
        with open(events, newline="", encoding="utf-8") as stream:
            wrinkles = [row for row in csv.DictReader(stream)
                        if row["event"] == "first wrinkles"][0]
        self.assertEqual(wrinkles["place"], "active")
        self.assertLess(float(wrinkles["x [m]"]), .04)
        # V/H sqrt(eps/G) = 0.2239 is 6.94 kV.
        self.assertLess(float(failed["wrinkled at [s]"]), 6.94 - .5)
        # The bar has gone 30 mm there.
        self.assertLess(float(failed["bar displacement [m]"]), .01)

    def test_margin_costs_stroke_and_brings_no_voltage(self):
        narrow, wide = self.run_study("clamped_margin", margin="1, 16",
                                      gap="12", refined="0")
        self.assertLess(float(wide["wrinkled at [s]"]),
                        float(narrow["wrinkled at [s]"]) + .15)
        self.assertLess(float(wide["bar displacement [m]"]),
                        .8 * float(narrow["bar displacement [m]"]))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
