#!/usr/bin/env python3
"""The case of a film that fails in several ways, as its readers meet it.

Usage: failure_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1:3]
CASE = Path(SOURCE) / "prm" / "film" / "failure.prm"
STOPPED_BY_EVENT = 4


class Failure(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut failure "))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_case(self, code, *words):
        done = subprocess.run(
            [PROGRAM, "run", CASE, "-o", self.folder / "out", *words],
            capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def read(self, name):
        file = self.folder / "out" / name
        with open(file, newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def test_margins_fall_to_zero_one_after_the_other(self):
        self.run_case(STOPPED_BY_EVENT)
        events = self.read("events.csv")
        self.assertEqual([event["kind"] for event in events],
                         ["wrinkling", "breakdown", "pull_in"])
        history = self.read("history.csv")
        times = [float(row["time [s]"]) for row in history]
        for event in events:
            self.assertAlmostEqual(float(event["margin"]), 0, delta=1e-9)
            margins = [float(row[f"margin {event['event']} [1]"])
                       for row in history]
            self.assertEqual(margins, sorted(margins, reverse=True))
            before = [margin > 0 for time, margin in zip(times, margins)
                      if time < float(event["time [s]"])]
            after = [margin < 0 for time, margin in zip(times, margins)
                     if float(event["time [s]"]) < time < times[-1]]
            self.assertTrue(all(before) and all(after))
        # The strength of the case is its law at the stretch of the event.
        spark = events[1]
        row = min(history, key=lambda row: abs(
            float(row["time [s]"]) - float(spark["time [s]"])))
        self.assertAlmostEqual(
            float(spark["value"]) / float(row["true field [V/m]"]), 1,
            delta=.02)

    def test_a_film_beyond_its_law_ends_with_value_range_and_place(self):
        said = self.run_case(
            3, "--set", "Material acrylic/Dielectric/Breakdown law = "
            "stretch(0.63; 1, 1.3)")
        for part in ("root of the area stretch is 1.3", "from 1 to 1.3",
                     "of the mesh"):
            self.assertIn(part, said)
        # What came before is kept.
        self.assertGreater(len(self.read("history.csv")), 10)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
