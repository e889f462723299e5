#!/usr/bin/env python3
"""The cases that follow paths through limit points, as their readers meet them.

Usage: path_cases_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1:3]
CASES = Path(SOURCE) / "prm"

# Limit loads of Lee's frame, peak and valley of a Gent film, threshold of the
# bow by the force of Euler and where a voltage makes it flat: closed forms or
# independent codes. Tolerances are those of the cases' meshes.
LEE = 1.85465587, -.93961424
GENT = .68936322, .27460055
GENT_STRETCH = 7.02628063
BOW = .0660620481, 1.9175408336


class PathCases(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut paths "))
        self.addCleanup(shutil.rmtree, self.folder)

    def read(self, name):
        with open(self.folder / name, newline="", encoding="utf-8") as stream:
            return [{key.split(" [")[0]: value for key, value in row.items()}
                    for row in csv.DictReader(stream)]

    def run_case(self, name):
        """Kinds and times of the events, and all rows of the history."""
        done = subprocess.run(
            [PROGRAM, "run", CASES / name, "-o", self.folder, "--overwrite"],
            capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        events = [(row["kind"], float(row["time"]))
                  for row in self.read("events.csv")]
        rows = [{key: float(value) for key, value in row.items()}
                for row in self.read("history.csv")]
        return events, rows

    def expect_events(self, events, expected, tolerance):
        self.assertEqual([kind for kind, _ in events],
                         [kind for kind, _ in expected])
        for (kind, time), (_, reference) in zip(events, expected):
            self.assertAlmostEqual(time, reference, delta=tolerance, msg=kind)

    def test_lees_frame_snaps_through_and_back(self):
        events, rows = self.run_case("frames/lee.prm")
        self.expect_events(events, [
            ("limit_point", LEE[0]), ("limit_point", LEE[1]),
            ("landing", LEE[0]),
            ("limit_point", LEE[1]), ("landing", LEE[1])], 1e-5)
        # There and back, over the jump.
        self.assertEqual(rows[0]["time"], -1.5)
        self.assertAlmostEqual(rows[-1]["deflection"], rows[0]["deflection"],
                               delta=1e-6)
        script = Path(SOURCE) / "postprocess" / "plot_path.py"
        python = shutil.which("python3", path="/usr/bin") or sys.executable
        subprocess.run([python, "-B", script, self.folder], check=True)
        plot = (self.folder / "path.svg").read_text(encoding="utf-8")
        for word in ("stable", "unstable", "jump", "limit point",
                     "landing after a jump", "Deflection (m)"):
            self.assertIn(f">{word}<", plot)

    def test_a_gent_film_snaps_through_and_back(self):
        events, rows = self.run_case("film/gent_snap.prm")
        self.expect_events(events, [
            ("limit_point", GENT[0]), ("limit_point", GENT[1]),
            ("landing", GENT[0]),
            ("limit_point", GENT[1]), ("landing", GENT[1])], 1e-7)
        landed = [row for row in rows
                  if abs(row["time"] - GENT[0]) < 1e-7 and row["stretch"] > 7]
        self.assertAlmostEqual(landed[0]["stretch"], GENT_STRETCH, delta=1e-6)
        # On the way back only states that a device can hold.
        turn = [row["time"] for row in rows].index(1)
        for row in rows[turn:]:
            self.assertEqual(row["negative eigenvalues"], 0)

    def test_an_inflated_membrane_passes_a_pressure_twice(self):
        events, rows = self.run_case("film/circular.prm")
        self.assertEqual([kind for kind, _ in events], ["limit_point"])
        apexes = [row["apex"] for row in rows if row["time"] == .9411968801]
        self.assertEqual(len(apexes), 2)
        self.assertAlmostEqual(apexes[0], .014200614512, delta=2e-6)

    def test_a_stretched_film_bends_its_frame_and_a_voltage_flattens_it(self):
        events, rows = self.run_case("demes/pitchfork.prm")
        met = [event for event in events if event[0] == "bifurcation"]
        self.expect_events(met, [("bifurcation", BOW[0]),
                                 ("bifurcation", BOW[1]),
                                 ("bifurcation", BOW[1]),
                                 ("bifurcation", BOW[0])], 1e-6)
        self.assertEqual(
            sum(kind == "branch_switch" for kind, _ in events), 4)
        at_rest = [row for row in rows if row["time"] == 1]
        for row in at_rest:
            self.assertAlmostEqual(abs(row["slope"]), 1.7630879393, delta=1e-5)
            self.assertAlmostEqual(row["stretch"], 1.3510502791, delta=1e-5)
        for row in rows:
            self.assertEqual(row["negative eigenvalues"], 0)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
