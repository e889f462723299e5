#!/usr/bin/env python3
"""Plants violations in a small tree and expects check_layers.py to see them."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).with_name("check_layers.py")

CLEAN = {
    "include/taut/base/signal.h": "#pragma once\n#include <vector>\n",
    "include/taut/fe/film.h": "// Film.\n#pragma once\n"
                              "#include <taut/base/signal.h>\n"
                              "#include <deal.II/base/mpi.h>\n",
    "include/taut/time/system.h": "#pragma once\n#include <arkode/arkode.h>\n",
    "include/taut/io/mesh.h": "#pragma once\n#include <fstream>\n"
                              "#include <gmsh.h>\n"
                              "#include <taut/fe/film.h>\n",
    "source/base/signal.cc": "#include <taut/base/signal.h>\n",
    "source/fe/film.cc": "#include <taut/fe/film.h>\n",
    "source/fe/film_kernel.cc": "#include <taut/fe/film.h>\n",
    "source/app/main.cc": "#include <taut/io/mesh.h>\n",
    "tests/fe/film_test.cc": "#include <taut/fe/film.h>\n",
    "tests/main.cc": "#include <deal.II/base/mpi.h>\n",
}


class CheckLayers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name, text in CLEAN.items():
            self.write(name, text)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def check(self):
        return subprocess.run([sys.executable, SCRIPT, self.root],
                              capture_output=True, text=True, check=False)

    def expect_refusal(self, name, text, *words):
        self.write(name, text)
        result = self.check()
        self.assertEqual(result.returncode, 1, result.stdout)
        lines = result.stdout.splitlines()
        self.assertEqual(len(lines), 1, result.stdout)
        for word in (name, *words):
            self.assertIn(word, lines[0])

    def expect_refused_include(self, name, include, *words):
        self.expect_refusal(name, f"#pragma once\n#include {include}\n", *words)

    def test_clean_tree_passes(self):
        result = self.check()
        self.assertEqual(result.returncode, 0, result.stdout)

    def test_arrows_hold_in_headers_sources_and_tests(self):
        for name in ("include/taut/base/x.h", "tests/material/x_test.h",
                     "source/time/x.h", "include/taut/lumped/x.h"):
            with self.subTest(name):
                self.expect_refused_include(name, "<taut/fe/film.h>",
                                            "must not include fe", ":2:")
                (self.root / name).unlink()

    def test_each_layer_refuses_the_one_above(self):
        above = [("base", "material"), ("base", "time"), ("material", "fe"),
                 ("time", "structure"), ("fe", "structure"), ("fe", "time"),
                 ("structure", "study"), ("structure", "lumped"),
                 ("lumped", "material"), ("time", "material"),
                 ("study", "io"), ("io", "app")]
        for layer, included in above:
            with self.subTest(layer=layer, included=included):
                name = f"include/taut/{layer}/x.h"
                self.expect_refused_include(name, f"<taut/{included}/y.h>",
                                            f"{layer} must not include {included}")
                (self.root / name).unlink()

    def test_allowed_arrows_pass(self):
        for layer, included in [("fe", "material"), ("structure", "time"),
                                ("study", "lumped"), ("io", "study"),
                                ("app", "base"), ("lumped", "time")]:
            self.write(f"include/taut/{layer}/allowed_{included}.h",
                       f"#pragma once\n#include <taut/{included}/y.h>\n")
        self.assertEqual(self.check().returncode, 0)

    def test_relative_paths_are_no_way_around(self):
        self.expect_refused_include("source/base/x.h",
                                    '"../../include/taut/fe/film.h"',
                                    "must not include fe")

    def test_test_helpers_are_no_way_around(self):
        self.write("tests/fe/helper.h", "#pragma once\n")
        self.expect_refused_include("tests/base/x.h", '"fe/helper.h"',
                                    "must not include fe")

    def test_libraries_stay_in_their_layers(self):
        cases = [("material", "<deal.II/base/tensor.h>", "deal.II"),
                 ("structure", "<deal.II/base/parameter_handler.h>",
                  "ParameterHandler"),
                 ("study", "<fstream>", "file access"),
                 ("base", "<filesystem>", "file access"),
                 ("fe", "<gmsh.h>", "gmsh"),
                 ("structure", "<vtkCell.h>", "VTK"),
                 ("lumped", "<cvode/cvode.h>", "SUNDIALS"),
                 ("fe", "<deal.II/sundials/ida.h>", "SUNDIALS"),
                 ("app", "<nvector/nvector_serial.h>", "SUNDIALS")]
        for layer, include, word in cases:
            with self.subTest(layer=layer, include=include):
                name = f"include/taut/{layer}/x.h"
                self.expect_refused_include(name, include, word)
                (self.root / name).unlink()

    def test_unknown_layers_are_refused(self):
        for name in ("include/taut/misc/x.h", "include/taut/x.h",
                     "source/misc/x.h", "source/x.h"):
            with self.subTest(name):
                self.expect_refusal(name, "#pragma once\n", "lies in no layer")
                (self.root / name).unlink()

    def test_includes_of_unknown_layers_are_refused(self):
        self.expect_refused_include("include/taut/io/x.h", "<taut/misc/x.h>",
                                    "is in no layer")

    def test_headers_begin_with_pragma_once(self):
        self.expect_refusal("include/taut/base/x.h",
                            "#include <vector>\n#pragma once\n", "#pragma once")

    def test_sources_belong_to_a_header(self):
        self.expect_refusal("source/fe/frame.cc", "int x;\n",
                            "implements no header")

    def test_long_files_are_refused(self):
        self.expect_refusal("tests/fe/long_test.cc", "int x;\n" * 401,
                            "401 lines")


if __name__ == "__main__":
    unittest.main()
