#!/usr/bin/env python3
"""The motion of a film and the lumped example cases, as their users meet them.

Usage: motion_test.py PROGRAM MPIEXEC SOURCE_FOLDER
"""

import csv
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from program import CASE, AppTest

SOURCE = Path(sys.argv[3])

# 37.5 swings of 1/600 s: the strobes fall between the rows of the history.
MOTION = """
subsection Motion
  set Of = lift
  set Period = 0.0015
  set From = 0.004
end
"""


def has_matplotlib():
    found = shutil.which("python3", path="/usr/bin")
    return found and subprocess.run([found, "-c", "import matplotlib"],
                                    check=False).returncode == 0


class Motion(AppTest):
    def setUp(self):
        super().setUp()
        self.write("case.prm", CASE + MOTION)

    def read_table(self, name, folder="out"):
        with open(self.folder / folder / name, newline="",
                  encoding="utf-8") as stream:
            rows = list(csv.reader(stream))
        return rows[0], [[float(field) for field in row] for row in rows[1:]]

    def test_section_of_a_film_is_made_of_rows(self):
        self.run_case(0)
        header, section = self.read_table("section.csv")
        self.assertEqual(header, ["time [s]", "lift [m]",
                                  "rate of lift [m/s]"])
        # Multiples of the period from 0.0045 s to 0.0615 s.
        self.assertEqual(len(section), 39)
        lifts = {row[0]: row[1] for row in self.read_history()[1]}
        for k, (time, lift, _) in enumerate(section):
            self.assertAlmostEqual(time, 0.0015 * (k + 3), delta=1e-14)
            row = min(lifts, key=lambda t, at=time: abs(t - at))
            # Both tables have 15 digits.
            self.assertAlmostEqual(row, time, delta=1e-14)
            self.assertAlmostEqual(lifts[row], lift, delta=1e-12 * abs(lift))
        motion = self.read_summary()["motion"]
        self.assertEqual(motion["section_points"], 39)
        self.assertIn(motion["class"], ("transient", "equilibrium"))
        # Nobody runs a film twice.
        self.assertNotIn("reproducible", motion)
        self.assertTrue((self.folder / "out/spectrum.csv").exists())

    def test_resumed_motion_is_the_whole_one(self):
        often = ["--set", "Checkpoint/Every steps = 20"]
        self.run_case(0, *often)
        whole = self.read_table("section.csv")[1]
        (self.folder / "out/section.csv").unlink()
        self.run_case(0, *often, "--resume")
        resumed = self.read_table("section.csv")[1]
        self.assertEqual(len(resumed), len(whole))
        for one, other in zip(whole, resumed):
            # The rows read back have 15 digits; the rate is their difference
            # over 1e-4 s.
            self.assertAlmostEqual(one[1], other[1],
                                   delta=1e-6 * abs(one[1]))

    def test_two_ranks_see_the_same(self):
        self.run_case(0)
        one = self.read_table("section.csv")[1]
        self.run_case(0, "--overwrite", ranks=2)
        two = self.read_table("section.csv")[1]
        self.assertEqual(len(one), len(two))
        largest = max(abs(row[1]) for row in one)
        for first, second in zip(one, two):
            self.assertAlmostEqual(first[1], second[1], delta=1e-7 * largest)

    def test_overwriting_leaves_no_old_tables(self):
        self.run_case(0)
        self.write("case.prm", CASE)
        self.run_case(0, "--overwrite")
        self.assertFalse((self.folder / "out/section.csv").exists())
        self.assertNotIn("motion", self.read_summary())

    def test_wrong_probe_is_refused_before_the_run(self):
        self.expect_refused(["Motion/Of", "did you mean 'lift'"], "run",
                            "case.prm", "-o", "out", "--set",
                            "Motion/Of = litf")
        self.assertFalse((self.folder / "out").exists())


class Examples(AppTest):
    def run_example(self, name):
        self.expect(0, "run", str(SOURCE / "prm/demes" / name), "-o", "out")
        return self.read_summary()

    def test_driven_demes_settles_to_its_period(self):
        motion = self.run_example("motion.prm")["motion"]
        self.assertEqual(motion["class"], "periodic")
        self.assertEqual(motion["period_number"], 1)
        # -0.024 in units of 2 pi 5 Hz, known to the last digit.
        self.assertAlmostEqual(motion["lyapunov_exponent"] / 31.42, -0.024,
                               delta=1e-3)
        self.assertTrue(motion["reproducible"])

    @unittest.skipUnless(has_matplotlib(), "needs matplotlib")
    def test_motion_is_plotted(self):
        self.run_example("motion.prm")
        out = self.folder / "out"
        subprocess.run(["/usr/bin/python3", SOURCE / "postprocess" /
                        "plot_motion.py", out], check=True)
        self.assertGreater((out / "motion.png").stat().st_size, 10000)
        self.assertIn("Periodic", (out / "motion.svg").read_text())

    def test_response_jumps(self):
        summary = self.run_example("response.prm")
        self.assertTrue(any("rises or falls" in note
                            for note in summary["notes"]))
        self.assertTrue((self.folder / "out/response.csv").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
