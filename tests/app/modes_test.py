#!/usr/bin/env python3
"""taut modes as its users meet it.

Usage: modes_test.py PROGRAM MPIEXEC
"""

import csv
import math
import unittest
from pathlib import Path

from program import AppTest

CASES = Path(__file__).resolve().parents[2] / "prm"


class ModesTest(AppTest):
    def find(self, case, *changes, folder="modes", code=0, ranks=1):
        """Rows of modes.csv by the names of the columns, and the summary."""
        words = [word for change in changes for word in ("--set", change)]
        result = self.expect(code, "modes", str(case), "-o", folder,
                             "--overwrite", *words, ranks=ranks)
        file = self.folder / folder / "modes.csv"
        rows = []
        if file.exists():
            with open(file, newline="", encoding="utf-8") as stream:
                rows = [{key.split(" [")[0]: float(value)
                         for key, value in row.items()}
                        for row in csv.DictReader(stream)]
        return rows, self.read_summary(folder), result.stdout

    def modes(self, case, *changes, **named):
        return self.find(case, *changes, **named)[0]


class Resonator(ModesTest):
    def test_ideal_one_is_the_lumped_one(self):
        for start in "relaxed", "unrelaxed":
            for volts in 0, 2000:
                common = f"Procedure/Start = {start}", "Modes/At = start"
                film, = self.modes(CASES / "resonator" / "ideal.prm", *common,
                                   f"Electrode active/Voltage = {volts}")
                lumped, = self.modes(CASES / "resonator" / "lumped.prm",
                                     *common,
                                     f"Lumped resonator/Voltage = {volts}")
                names = ["frequency", "omega T network 2"]
                if start == "relaxed":
                    # Else the damping depends on how far it has relaxed.
                    names += ["damping ratio", "damped frequency"]
                for name in names:
                    self.assertAlmostEqual(film[name] / lumped[name], 1,
                                           delta=1e-9)
                self.assertGreater(lumped["damping ratio"], .01)

    def test_at_the_end_it_is_softer_and_ranks_agree(self):
        case = CASES / "resonator" / "modes.prm"
        start, _, _ = self.find(case, "Modes/At = start", "Modes/Count = 6")
        end, summary, _ = self.find(case, "Modes/Count = 6")
        self.assertEqual(len(end), 6)
        for before, after in zip(start, end):
            self.assertLess(after["frequency"], before["frequency"])
        self.assertTrue(summary["modes"]["stable"])
        # Bars of 20 g, of 20.8 g in all, along z, x and y.
        for mode, axis in zip(end, "zxy"):
            self.assertAlmostEqual(mode["share of mass " + axis], .976,
                                   delta=.01)
        twice, _, _ = self.find(case, "Modes/Count = 6", ranks=2)
        for one, two in zip(end, twice):
            self.assertAlmostEqual(one["frequency"] / two["frequency"], 1,
                                   delta=1e-9)
            self.assertAlmostEqual(one["damping ratio"], two["damping ratio"],
                                   delta=1e-9)
        frames = (self.folder / "modes" / "fields.pvd").read_text()
        self.assertEqual(frames.count("timestep"), 7)

    def test_modes_next_to_a_frequency(self):
        case = CASES / "resonator" / "modes.prm"
        lowest, summary, _ = self.find(case, "Modes/Count = 7")
        near, other, _ = self.find(case, "Modes/Count = 2",
                                   "Modes/Near frequency = 180")
        for a, b in zip(lowest[5:], near):
            self.assertAlmostEqual(a["frequency"] / b["frequency"], 1,
                                   delta=1e-9)
        self.assertAlmostEqual(other["modes"]["lowest_relaxed"] /
                               summary["modes"]["lowest_relaxed"], 1,
                               delta=1e-9)

    def test_a_case_with_modes_still_runs(self):
        self.expect(0, "run", str(CASES / "resonator" / "modes.prm"), "-o",
                    "run")
        self.assertNotIn("modes", self.read_summary("run"))


# An elastica bent by a film of held width between its ends, pre-stretch 3,
# K_bb = 1: frequencies of its symmetric swing over sqrt(mu V/I) with relaxed and
# with stuck networks (boundary value problem, independent code).
ELASTICA = {"relaxed": 1.624394498074, "frozen": 1.940647801291}


class Demes(ModesTest):
    def test_bow_swings_as_the_elastica(self):
        unit = math.sqrt(52246.6 * .02 * .04 * 5e-4 / (2 * 1.058738e-5))
        for networks, expected in ELASTICA.items():
            rows = self.modes(CASES / "demes" / "elastica.prm",
                              "Modes/At = start", "Modes/Count = 2",
                              f"Modes/Networks = {networks}")
            # The first mode is antisymmetric and leaves the film's length.
            omega = math.sqrt(rows[1]["angular frequency squared"]) / unit
            # The mass of legs and film takes some 2e-5.
            self.assertAlmostEqual(omega / expected, 1, delta=5e-5)
            self.assertAlmostEqual(rows[0]["damping ratio"], 0, delta=1e-9)
            self.assertGreater(rows[1]["damping ratio"], .005)

    def test_flat_is_unstable_and_rest_is_not(self):
        case = CASES / "demes" / "bonded.prm"
        _, rest, _ = self.find(case, "Modes/At = start", "Modes/Count = 2")
        self.assertTrue(rest["modes"]["stable"])
        self.assertGreater(rest["modes"]["lowest_relaxed"], 0)
        rows, flat, text = self.find(case, "Modes/At = start",
                                     "Modes/Count = 2",
                                     "Procedure/Start shape = equilibrium")
        self.assertFalse(flat["modes"]["stable"])
        self.assertLess(flat["modes"]["lowest_relaxed"], 0)
        self.assertGreaterEqual(flat["modes"]["unstable_relaxed"], 1)
        self.assertEqual(rows[0]["frequency"], 0)
        self.assertGreater(rows[0]["growth rate"], 0)
        self.assertIn("unstable", text)

    def test_lumped_one_starts_flat_or_at_rest(self):
        case = CASES / "demes" / "lumped.prm"
        common = "Modes/At = start", "Procedure/End time = 0.01"
        row, = self.modes(case, *common, "Lumped DEMES/Begin = rest")
        self.assertGreater(row["frequency"], 0)
        relaxed, = self.modes(case, *common, "Lumped DEMES/Begin = rest",
                              "Modes/Networks = relaxed")
        self.assertLess(relaxed["frequency"], row["frequency"])
        # It vibrates faster than without the dashpot, slower than with it stuck.
        self.assertLess(row["damped frequency"], row["frequency"])
        self.assertGreater(row["damped frequency"],
                           .99 * relaxed["frequency"])
        _, flat, _ = self.find(case, *common, "Lumped DEMES/Begin = flat")
        self.assertFalse(flat["modes"]["stable"])


class Refusals(ModesTest):
    def test_no_equilibrium_next_to_the_state(self):
        # Pull-in: the film thins without end.
        rows, summary, _ = self.find(
            "case.prm", "Modes/At = start", "Procedure/Start shape = meshed",
            "Electrode active/Voltage = 1e5", "Film active/Tension field = false",
            "Film passive/Tension field = false", code=3)
        self.assertEqual(rows, [])
        self.assertEqual(summary["status"], "failed")
        self.assertIn("no equilibrium", summary["reason"])
        self.assertNotIn("modes", summary)

    def test_states_that_still_relax_are_told(self):
        _, summary, _ = self.find("case.prm", "Modes/At = start",
                                  "Procedure/Start = unrelaxed")
        self.assertTrue(any("still relax" in note
                            for note in summary["notes"]))

    def test_an_event_ends_the_way(self):
        _, summary, _ = self.find("case.prm", "Event far/Fatal = true", code=4)
        self.assertNotIn("modes", summary)
        self.assertTrue(any("no vibration modes" in note
                            for note in summary["notes"]))

    def test_keys(self):
        self.expect_refused(["Count"], "modes", "case.prm", "--set",
                            "Modes/Count = 0")
        self.expect_refused(["Near frequency"], "modes", "case.prm", "--set",
                            "Modes/Near frequncy = 3")
        self.expect_refused(["one mode", "Near frequency"], "modes",
                            str(CASES / "demes" / "lumped.prm"), "--set",
                            "Modes/Near frequency = 3", "-o", "near")

    def test_folder_of_another_run(self):
        self.find("case.prm", "Modes/At = start", "Modes/Count = 1")
        self.expect_refused(["--overwrite"], "modes", "case.prm", "-o",
                            "modes")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
