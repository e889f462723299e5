#!/usr/bin/env python3
"""The cases of prm/demes as their readers meet them.

Usage: demes_cases_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1:3]
CASES = Path(SOURCE) / "prm" / "demes"

# End slope of the bow over Et, pre-stretch 3, K_bb = 1: elliptic integrals.
BOW = {0.: 1.5264068249, .2: 1.5091254270, .4: 1.4476943834,
       .6: 1.2942757789, .8: .7364634942}
# Et above which it is flat.
FLAT = .8446884888

# End slope and stretch on stand-offs as high as the beam is long: the model of
# one angle, in closed form, and the elastica, by shooting.
ARC = .09934132842147, 1.6
ELASTICA = .09934344583796, 1.599969774763


class DemesCases(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut demes "))
        self.addCleanup(shutil.rmtree, self.folder)

    def call(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True,
                              text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def run_case(self, name, *words):
        """All rows of the history, by the names of the probes."""
        self.call("run", CASES / name, "-o", self.folder, "--overwrite", *words)
        file = self.folder / "history.csv"
        with open(file, newline="", encoding="utf-8") as stream:
            return [{key.split(" [")[0]: float(value)
                     for key, value in row.items()}
                    for row in csv.DictReader(stream)]

    def test_all_are_in_order(self):
        cases = sorted(CASES.glob("*.prm"))
        self.assertTrue(cases)
        for case in cases:
            with self.subTest(case.name):
                self.call("check", case)

    def test_bow_is_the_elastica(self):
        rows = {round(row["time"], 6): row for row in self.run_case("bow.prm")}
        for field, slope in BOW.items():
            # 40 elements; the strain along the beam adds some 1e-6.
            self.assertAlmostEqual(rows[field]["slope"], slope, delta=1e-5)
        # Pre-stretch times chord over length, and the height k/K of the bow.
        self.assertAlmostEqual(rows[0]["stretch"], 1.4507784387, delta=1e-5)
        self.assertAlmostEqual(rows[0]["height"] / .06, .3765497001, delta=1e-5)
        for field, row in rows.items():
            if field > FLAT:
                self.assertAlmostEqual(row["slope"], 0, delta=1e-6)
            else:
                self.assertGreater(row["slope"], .1)

    def test_stand_offs_lead_to_the_model_of_one_angle(self):
        last = self.run_case("lumped_limit.prm")[-1]
        found = last["half angle"], last["stretch"]
        for value, arc, elastica in zip(found, ARC, ELASTICA, strict=True):
            # 40 elements, far below the difference of the two models.
            self.assertAlmostEqual(value / elastica, 1, delta=1e-7)
            # As (C/h)^4, which at h = C is 2.1e-5 and 1.9e-5.
            self.assertLess(abs(value / arc - 1), 2.2e-5)

    def test_films_on_the_face_of_a_soft_frame_find_one_rest_shape(self):
        # No equilibrium is near the flat state here.
        heights = []
        for perturbation in (.2, 2):
            rows = self.run_case(
                "../../docs/tutorial/finger.prm",
                "--set", "Frame frame/Thickness = 2.5e-4",
                "--set", f"Procedure/Rest shape/Perturbation = {perturbation}",
                "--set", "Procedure/End time = 1",
                "--set", "Procedure/Load steps = 1")
            heights.append(rows[0]["tip height"])
        self.assertGreater(heights[0], .01)
        # The equilibria are known to 1e-10 of their forces.
        self.assertAlmostEqual(heights[0], heights[1], delta=1e-8)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
