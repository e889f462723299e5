#!/usr/bin/env python3
"""Words and cases that taut refuses, and what it tells without running.

Usage: refusals_test.py PROGRAM MPIEXEC
"""

import sys
import unittest

from program import CASE, GEOMETRY, AppTest


class Words(AppTest):
    def test_version_and_help(self):
        self.assertIn("deal.II", self.expect(0, "--version").stdout)
        self.assertIn("Exit codes", self.expect(0, "--help").stdout)

    def test_describe(self):
        self.assertIn("Thickness", self.expect(0, "describe", "Film").stdout)
        self.expect_refused(["'Film'"], "describe", "Flim")

    def test_wrong_words_are_refused(self):
        self.expect_refused(["--help"])
        self.expect_refused(["--help"], "walk", "case.prm")
        self.expect_refused(["CASE"], "run")
        self.expect_refused(["--fast"], "run", "case.prm", "--fast")
        self.expect_refused(["--overwrite"], "run", "case.prm", "--resume",
                            "--overwrite")


class Check(AppTest):
    def test_says_what_the_case_is(self):
        text = self.expect(0, "check", "case.prm").stdout
        self.assertIn("8 cells", text)
        # 20 mm x 20 mm, stretched by 2 and 2, 1 mm thick, 1000 kg/m^3.
        self.assertIn("0.0004 m^2 in the mesh, 0.0001 m^2 undeformed, 0.0001 kg",
                      text)
        self.assertIn("bar middle: 0.02 m, 0.01 kg", text)
        self.assertFalse((self.folder / "results").exists())


class BadInput(AppTest):
    def refuse(self, old, new, *fragments, ranks=1):
        """The case with `old` replaced by `new` is refused before any output."""
        text = CASE.replace(old, new, 1)
        self.assertNotEqual(text, CASE)
        self.write("case.prm", text)
        self.expect_refused(fragments, "run", "case.prm", "-o", "out",
                            ranks=ranks)
        self.assertFalse((self.folder / "out").exists())

    def test_unknown_key(self):
        self.refuse("set Density", "set Densty", "case.prm:6:",
                    "Material rubber/Densty", "did you mean 'Density'")

    def test_key_given_twice(self):
        self.refuse("  set Density = 1000", "  set Density = 1000\n"
                    "  set Density = 900", "case.prm:7:", "Density")

    def test_number_with_a_unit(self):
        self.refuse("modulus = 2e4", "modulus = 20 kPa", "case.prm:9:",
                    "Shear modulus")

    def test_negative_thickness(self):
        self.refuse("Thickness = 1e-3", "Thickness = -1e-3", "case.prm:24:",
                    "Thickness")

    def test_voltage_table_back_in_time(self):
        self.refuse("0.002: 2000", "-0.002: 2000", "case.prm:35:", "Voltage")

    def test_group_that_the_mesh_lacks(self):
        self.refuse("Groups = sides", "Groups = side", "case.prm:41:", "'side'",
                    "'sides'")

    def test_group_of_two_films(self):
        self.refuse("Surfaces = passive", "Surfaces = active, passive",
                    "case.prm:", "'active'")

    def test_event_on_a_probe_that_is_not_there(self):
        self.refuse("Of = lift", "Of = left", "case.prm:", "'lift'")

    def test_triangles(self):
        self.write("mesh.geo", GEOMETRY.replace("RECOMBINE", ""))
        self.expect_refused(["mesh.geo", "triangles", "Recombine"], "check",
                            "case.prm")

    def test_empty_and_missing_files(self):
        self.write("mesh.geo", "")
        self.expect_refused(["mesh.geo", "empty"], "check", "case.prm")
        (self.folder / "mesh.geo").unlink()
        self.expect_refused(["mesh.geo", "missing"], "run", "case.prm")
        self.expect_refused(["none.prm"], "run", "none.prm")

    def test_all_ranks_refuse_in_one_line(self):
        self.refuse("Groups = sides", "Groups = side", "case.prm:41:",
                    "'sides'", ranks=2)
        self.write("mesh.geo", "")
        self.expect_refused(["mesh.geo", "empty"], "check", "case.prm", ranks=2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
