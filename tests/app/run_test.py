#!/usr/bin/env python3
"""Runs through the command line: files, exit codes, resuming.

Usage: run_test.py PROGRAM MPIEXEC
"""

import signal
import subprocess
import sys
import time
import unittest

from program import PROGRAM, AppTest


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

    def test_film_compressed_at_the_start_is_noted(self):
        self.run_case(0, "--set", "Procedure/End time = 0.001")
        self.assertEqual(self.read_summary()["notes"], [])
        self.run_case(0, "--overwrite",
                      "--set", "Procedure/End time = 0.001",
                      "--set", "Procedure/Start shape = meshed",
                      "--set", "Film passive/Pre-stretch = 2, 0.5")
        [note] = self.read_summary()["notes"]
        self.assertIn("compression", note)

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
        self.assertEqual(self.read_events("whole"), self.read_events("out"))

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
