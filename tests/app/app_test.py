#!/usr/bin/env python3
"""The program taut through its command line: exit codes, messages, files.

Usage: app_test.py PROGRAM MPIEXEC
"""

import csv
import json
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM, MPIEXEC = str(Path(sys.argv[1]).resolve()), sys.argv[2]

# Two squares of 20 mm x 20 mm side by side.
GEOMETRY = """
size = 0.02;
Point(1) = {0, 0, 0}; Point(2) = {size, 0, 0}; Point(3) = {2 * size, 0, 0};
Point(4) = {2 * size, size, 0}; Point(5) = {size, size, 0};
Point(6) = {0, size, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 5};
Line(5) = {5, 6}; Line(6) = {6, 1}; Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6}; Plane Surface(1) = {1};
Curve Loop(2) = {2, 3, 4, -7}; Plane Surface(2) = {2};
Transfinite Curve {1 : 7} = 3; Transfinite Surface {1, 2};
RECOMBINE
Physical Surface("active") = {1};
Physical Surface("passive") = {2};
Physical Curve("ends") = {3, 6};
Physical Curve("sides") = {1, 2, 4, 5};
Physical Curve("middle") = {7};
"""

CASE = """set Title = two squares
subsection Mesh
  set File = mesh.geo
end
subsection Material rubber
  set Density = 1000
  subsection Spring ground
    set Law = neo-Hookean
    set Shear modulus = 2e4
  end
  subsection Network slow
    set Law = neo-Hookean
    set Shear modulus = 1e4
    set Relaxation time = 0.01
  end
  subsection Dielectric
    set Relative permittivity = 4.7
    set Breakdown strength = 1e8
  end
end
subsection Film active
  set Surfaces = active
  set Material = rubber
  set Thickness = 1e-3
  set Pre-stretch = 2, 2
end
subsection Film passive
  set Surfaces = passive
  set Material = rubber
  set Thickness = 1e-3
  set Pre-stretch = 2, 2
end
subsection Electrode active
  set Surfaces = active
  set Voltage = table(0: 0, 0.002: 2000)
end
subsection Support ends
  set Groups = ends
  set Held = x, y, z
end
subsection Support sides
  set Groups = sides
  set Held = y, z
end
subsection Bar middle
  set Lines = middle
  set Mass = 0.01
  set Free = x
  set Rotates = false
end
subsection Probe lift
  set Quantity = bar displacement
  set Of = middle
  set Component = x
end
subsection Event far
  set Kind = probe above
  set Of = lift
  set Threshold = 1e-6
  set Fatal = false
end
subsection Procedure
  set Start = relaxed
  set End time = 0.0625
end
subsection Output
  set History intervals = 16
  set Field intervals = 2
end
"""


class AppTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut app "))
        self.addCleanup(shutil.rmtree, self.folder)
        self.write("mesh.geo",
                   GEOMETRY.replace("RECOMBINE", "Recombine Surface {1, 2};"))
        self.write("case.prm", CASE)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def call(self, *words, ranks=1):
        command = [PROGRAM, *words]
        if ranks > 1:
            command = [MPIEXEC, "-n", str(ranks), *command]
        return subprocess.run(command, cwd=self.folder, capture_output=True,
                              text=True, timeout=120, check=False)

    def expect(self, code, *words, ranks=1):
        result = self.call(*words, ranks=ranks)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def expect_refused(self, fragments, *words, ranks=1):
        """Exit code 2 and one line on stderr that holds all fragments."""
        result = self.expect(2, *words, ranks=ranks)
        lines = [line for line in result.stderr.splitlines()
                 if ranks == 1 or line.startswith("taut:")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("taut: "), lines[0])
        for fragment in fragments:
            self.assertIn(fragment, lines[0])

    def run_case(self, code, *words, ranks=1):
        return self.expect(code, "run", "case.prm", "-o", "out", *words,
                           ranks=ranks)

    def read_summary(self, folder="out"):
        text = (self.folder / folder / "run.json").read_text(encoding="utf-8")
        return json.loads(text)

    def read_history(self, folder="out"):
        file = self.folder / folder / "history.csv"
        with open(file, newline="", encoding="utf-8") as stream:
            rows = list(csv.reader(stream))
        return rows[0], [[float(field) for field in row] for row in rows[1:]]

    def read_events(self, folder="out"):
        file = self.folder / folder / "events.csv"
        with open(file, newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))


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
        """Both commands refuse the case with `old` replaced by `new`."""
        text = CASE.replace(old, new, 1)
        self.assertNotEqual(text, CASE)
        self.write("case.prm", text)
        for words in (("check", "case.prm"), ("run", "case.prm", "-o", "out")):
            self.expect_refused(fragments, *words, ranks=ranks)
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


class Run(AppTest):
    def test_writes_what_the_contract_says(self):
        self.run_case(0)
        out = self.folder / "out"
        for name in ("parameters.prm", "history.csv", "events.csv",
                     "fields.pvd", "log.txt"):
            self.assertTrue((out / name).stat().st_size > 0, name)
        header, rows = self.read_history()
        self.assertEqual(header[:2], ["time [s]", "lift [m]"])
        self.assertEqual([row[0] for row in rows],
                         [i / 256 for i in range(17)])
        self.assertEqual(len(list((out / "fields").glob("*.vtu"))), 3)
        summary = self.read_summary()
        self.assertEqual(summary["status"], "completed")
        # The table has 15 digits.
        self.assertAlmostEqual(summary["final"]["lift"], rows[-1][1],
                               delta=1e-14 * abs(rows[-1][1]))
        # The tolerance of the steps is far below the motion.
        self.assertLess(summary["energy_balance"]["relative"], 1e-3)
        self.assertGreater(summary["peak_memory_bytes"], 1e6)
        self.assertEqual(summary["parameters_changed"]["Film active/Thickness"]
                         ["value"], "1e-3")
        # The effective parameters are a case themselves.
        self.expect(0, "check", "out/parameters.prm")

    def test_folder_of_another_run_is_refused(self):
        self.run_case(0)
        before = (self.folder / "out/history.csv").read_bytes()
        self.expect_refused(["out", "--resume", "--overwrite"], "run",
                            "case.prm", "-o", "out")
        self.expect_refused(["out", "checkpoint"], "run", "case.prm", "-o",
                            "out", "--resume")
        self.assertEqual((self.folder / "out/history.csv").read_bytes(), before)
        self.run_case(0, "--overwrite")

    def test_default_folder_and_overrides(self):
        self.expect(0, "run", "case.prm", "--set", "Procedure/End time = 0.01",
                    "--set", "Output/Write fields = false")
        folder = "results/case"
        self.assertEqual(self.read_summary(folder)["time_reached"], 0.01)
        self.assertFalse((self.folder / folder / "fields.pvd").exists())

    def test_fatal_event(self):
        self.run_case(4, "--set", "Event far/Fatal = true")
        summary = self.read_summary()
        self.assertEqual(summary["status"], "event")
        self.assertIn("far", summary["reason"])
        # It fires where the probe passes the threshold.
        event = self.read_events()[-1]
        self.assertAlmostEqual(float(event["value"]), 1e-6, delta=1e-12)
        self.assertEqual(event["fatal"], "true")

    def test_failure_of_the_solver_leaves_all_output(self):
        self.run_case(3, "--set", "Procedure/Integrator/Most steps = 5")
        summary = self.read_summary()
        self.assertEqual(summary["status"], "failed")
        self.assertTrue(summary["reason"])
        self.assertGreater(len(self.read_history()[1]), 0)

    def test_two_ranks_agree_with_one(self):
        self.run_case(0)
        self.expect(0, "run", "case.prm", "-o", "two", ranks=2)
        for one, two in zip(self.read_history()[1],
                            self.read_history("two")[1], strict=True):
            # Ten times the tolerance of the positions.
            self.assertAlmostEqual(one[1], two[1], delta=1e-7)


class Resume(AppTest):
    def compare(self, folder, difference):
        header, whole = self.read_history("whole")
        other_header, resumed = self.read_history(folder)
        self.assertEqual(header, other_header)
        self.assertEqual(len(whole), len(resumed))
        for column in range(len(header)):
            scale = max(abs(row[column]) for row in whole)
            for one, other in zip(whole, resumed):
                self.assertAlmostEqual(one[column], other[column],
                                       delta=difference * scale + 1e-300)

    def test_split_run_is_the_whole_run(self):
        often = ("--set", "Checkpoint/Every steps = 7")
        self.expect(0, "run", "case.prm", "-o", "whole", *often)
        self.run_case(0, *often, "--set", "Procedure/End time = 0.03125",
                      "--set", "Output/History intervals = 8",
                      "--set", "Output/Field intervals = 1")
        self.run_case(0, *often, "--resume")
        self.compare("out", 1e-12)
        whole, resumed = (
            [event for event in self.read_events(name)
             if event["at start"] == "false"] for name in ("whole", "out"))
        self.assertEqual(whole, resumed)

    def test_changed_physics_is_refused(self):
        self.run_case(0, "--set", "Checkpoint/Every steps = 7")
        self.expect_refused(["Material rubber/Density", "900"], "run",
                            "case.prm", "-o", "out", "--resume", "--set",
                            "Material rubber/Density = 900")

    def test_damaged_checkpoint_is_refused(self):
        self.run_case(0, "--set", "Checkpoint/Every steps = 7")
        state = self.folder / "out/checkpoint/state"
        state.write_bytes(state.read_bytes()[:-1])
        self.expect_refused(["checkpoint/state", "cut off"], "run", "case.prm",
                            "-o", "out", "--resume")

    def test_signal_leaves_a_checkpoint(self):
        long = ("run", "case.prm", "-o", "out", "--set",
                "Procedure/End time = 1000")
        with subprocess.Popen([PROGRAM, *long], cwd=self.folder,
                              stdout=subprocess.DEVNULL) as process:
            history = self.folder / "out/history.csv"
            until = time.monotonic() + 60
            while time.monotonic() < until and not (
                    history.exists() and history.read_text().count("\n") > 1):
                time.sleep(0.02)
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(60), 5)
        stopped = self.read_summary()
        self.assertEqual(stopped["status"], "interrupted")
        self.run_case(0, "--resume", "--set", "Procedure/End time = "
                      f"{stopped['time_reached'] + 0.01}")
        self.assertEqual(self.read_summary()["status"], "completed")


class Lumped(AppTest):
    def test_runs_to_its_failure(self):
        self.write("lumped.prm", """set Model = resonator
subsection Lumped resonator
  set Length active = 0.02
  set Length passive = 0.02
  set Width = 0.02
  set Thickness = 1e-3
  set Pre-stretch = 2, 4
  set Bar mass = 0.02
  set Density = 960
  set Shear modulus = 40e3
  set Breakdown strength = 155e6
  set Voltage = ramp(rate = 9300, start = 0, limit = inf)
end
subsection Procedure
  set Analysis = quasi-static
  set Start = unrelaxed
  set End time = 2
end
""")
        self.expect(4, "run", "lumped.prm", "-o", "out")
        self.assertEqual(self.read_summary()["status"], "event")
        self.assertIn("no mesh", self.expect(0, "check", "lumped.prm").stdout)
        self.expect_refused(["checkpoint"], "run", "lumped.prm", "-o", "out",
                            "--resume")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
