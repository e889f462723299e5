#!/usr/bin/env python3
"""`taut compare` and the plots as their users meet them.

Usage: compare_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1:3]
CASES = Path(SOURCE) / "prm" / "resonator"


def read_pixels(file):
    """Width, height and the bytes of a PNG's rows, filters not undone."""
    data = file.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    place, packed, size = 8, b"", None
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    return size[0], size[1], zlib.decompress(packed)


class CompareTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut compare "))
        self.addCleanup(shutil.rmtree, self.folder)

    def call(self, *words, **environment):
        return subprocess.run(
            [PROGRAM, *map(str, words)], capture_output=True, text=True,
            env={**os.environ, **environment}, check=False)

    def compare(self, case, *words, **environment):
        done = self.call("compare", CASES / case, "-o", self.folder / "out",
                         *words, **environment)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        text = (self.folder / "out" / "compare.json").read_text()
        return done, json.loads(text)

    def assert_not_blank(self, file):
        width, height, pixels = read_pixels(file)
        self.assertGreater(width, 1000)
        self.assertGreater(height, 500)
        # Lines are drawn: not all rows of the picture are the same.
        row = len(pixels) // height
        rows = {pixels[i:i + row] for i in range(0, len(pixels), row)}
        self.assertGreater(len(rows), height // 10)

    def test_a_demes_is_compared_with_elastica_and_arc(self):
        mesh = ("hole_length: 0.04, hole_width: 0.04, leg_width: 5.015e-3, "
                "cells_along: 4, cells_across: 4, cells_leg: 10")
        done, result = self.compare(
            "../demes/dc.prm", "--set", "Procedure/End time = 0.02", "--set",
            "Mesh/Parameters = " + mesh)
        rest = {model["name"]: model["rest"] for model in result["models"]}
        # Closed forms for pre-stretch 2 and K = 1, which dc.prm rounds.
        self.assertAlmostEqual(rest["elastica"]["stretch"], 1.6092, delta=3e-4)
        self.assertAlmostEqual(rest["arc"]["stretch"], 1.7824, delta=3e-4)
        # The width is free: less than 5 % from the elastica, more from the arc.
        film = rest["finite elements"]["stretch"]
        self.assertLess(abs(film / rest["elastica"]["stretch"] - 1), 0.05)
        self.assertGreater(abs(film / rest["arc"]["stretch"] - 1), 0.05)
        self.assertEqual(
            [quantity["name"] for quantity in result["quantities"]],
            [name + of for of in ("", " (elastica)")
             for name in ("angle", "chord", "stretch")])
        self.assertIn("width of the film is free", done.stdout)
        self.assert_not_blank(self.folder / "out" / "compare.png")

    def test_the_ideal_resonator_agrees_with_the_lumped_model(self):
        done, result = self.compare("ideal.prm")
        names = {quantity["name"] for quantity in result["quantities"]}
        self.assertLessEqual(
            {"stretch active", "stretch passive", "bar displacement",
             "nominal stress 1 active", "nominal stress 2 passive",
             "force active", "charge"}, names)
        # What ideal.prm says: R0 of the lumped model's limits.
        for quantity in result["quantities"]:
            self.assertLess(quantity["max_relative_difference"], 1e-6,
                            quantity)
            self.assertLessEqual(quantity["rms_relative_difference"],
                                 quantity["max_relative_difference"])
            self.assertLessEqual(quantity["time_of_max"],
                                 result["compared_until"])
            self.assertIn(quantity["name"], done.stdout)
        failure = result["events"]["failure_difference"]
        self.assertLess(abs(failure["time"]), 1e-6)
        self.assertLess(abs(failure["voltage"]), 1e-6)
        self.assertTrue(failure["same_kind"] and failure["same_place"])
        self.assertEqual(result["ignored"], [])
        self.assertEqual(result["lumped_resonator"]["bar_mass"], 0.02)
        self.check_table(result)
        self.check_plots()

    def check_table(self, result):
        with open(self.folder / "out" / "compare.csv", newline="") as stream:
            rows = list(csv.reader(stream))
        self.assertEqual(rows[0][:2], ["time [s]", "voltage [V]"])
        self.assertEqual(len(rows[0]), 2 + 2 * len(result["quantities"]))
        self.assertIn("charge film [C]", rows[0])
        last = float(rows[-1][0])
        self.assertAlmostEqual(last, result["compared_until"], places=6)

    def check_plots(self):
        self.assert_not_blank(self.folder / "out" / "compare.png")
        picture = (self.folder / "out" / "compare.svg").read_text()
        for text in ("finite elements", "lumped model", "Charge"):
            self.assertIn(text, picture)

    def test_without_matplotlib_the_numbers_stay(self):
        empty = self.folder / "python3"
        empty.write_text("#!/bin/sh\nexit 1\n")
        empty.chmod(0o755)
        done, result = self.compare("ideal.prm", TAUT_PYTHON=str(empty))
        self.assertGreater(len(result["quantities"]), 0)
        self.assertIn("python3-matplotlib", done.stdout)
        self.assertFalse((self.folder / "out" / "compare.png").exists())

    def test_a_case_that_the_lumped_model_cannot_represent_is_refused(self):
        done = self.call("compare", CASES / "ideal.prm", "-o",
                         self.folder / "out", "--set",
                         "Bar middle/Free = none")
        self.assertEqual(done.returncode, 2)
        self.assertIn("moves along x", done.stderr)
        self.assertIn("Bar middle", done.stderr)
        self.assertFalse((self.folder / "out").exists())

    def test_a_lumped_case_has_nothing_to_compare_with(self):
        done = self.call("compare", CASES / "lumped.prm", "-o",
                         self.folder / "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("Comparison", done.stderr)

    def test_the_history_of_a_run_is_plotted(self):
        done = self.call("run", CASES / "lumped.prm", "-o",
                         self.folder / "out")
        # The run ends with the loss of tension.
        self.assertEqual(done.returncode, 4, done.stderr)
        script = Path(SOURCE) / "postprocess" / "plot_history.py"
        python = shutil.which("python3", path="/usr/bin") or sys.executable
        subprocess.run([python, "-B", script, self.folder / "out"], check=True)
        self.assert_not_blank(self.folder / "out" / "history.png")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
