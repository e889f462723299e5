#!/usr/bin/env python3
"""taut study: tables, folders, failures and refusals.

Usage: study_test.py PROGRAM MPIEXEC
"""

import os
import sys
import unittest

from studies import FILM_STUDY, LUMPED, STUDY, StudyTest

BAD_INPUT, SOLVER_FAILED = 2, 3


class Table(StudyTest):
    def test_a_row_is_what_the_case_alone_gives(self):
        self.run_study(0, "--jobs", "2")
        rows = self.read_table()
        self.assertEqual(len(rows), 6)
        self.assertEqual(
            list(rows[0]),
            ["case [1]", "pre_stretch [1]", "source", "last angle [rad]",
             "swing [rad]", "time reached [s]", "seconds [s]", "status",
             "reason", "folder"])
        row = rows[3]
        self.assertEqual((row["pre_stretch [1]"], row["source"]),
                         ("2.5", "5000"))
        self.expect(0, "run", "lumped.prm", "-o", "alone",
                    "--set", "Lumped DEMES/Pre-stretch = 2.5")
        header, history = self.read_history("alone")
        angle = header.index("angle [rad]")
        self.assertEqual(float(row["last angle [rad]"]), history[-1][angle])
        late = [values[angle] for values in history if values[0] >= 0.1]
        self.assertAlmostEqual(float(row["swing [rad]"]),
                               (max(late) - min(late)) / 2, delta=1e-14)
        # Its folder is that of a run.
        self.assertEqual(row["folder"], "cases/2.5_5000")
        self.assertEqual(self.read_history("out/" + row["folder"]),
                         (header, history))
        self.assertEqual(self.read_summary("out/" + row["folder"])["status"],
                         "completed")

    def test_the_number_of_workers_and_kept_folders_change_nothing(self):
        self.run_study(0, "--jobs", "1", folder="one")
        self.run_study(0, "--jobs", "2", folder="two")
        self.assert_same_tables(self.read_table("one"), self.read_table("two"))
        self.run_study(0, "--set", "Keep folders = false", folder="table")
        without = self.read_table("table")
        self.assertFalse((self.folder / "table" / "cases").exists())
        for row, other in zip(without, self.read_table("one")):
            self.assertEqual(row.pop("folder"), "")
            row["folder"] = other["folder"]
        self.assert_same_tables(without, self.read_table("one"))

    def test_modes_of_each_case(self):
        """Instantaneous frequencies of the resting DEMES at pre-stretches 2 and
        3: 1.1409 and 3.0300 times 5 Hz for K = 1, beta = 2.5. Legs whose
        width grows with their length keep K = 1."""
        self.write("modes.prm", """set Case = lumped.prm
set Command = modes
subsection Vary pre_stretch
  set Values = 2, 3
  set Key = Lumped DEMES/Pre-stretch
end
subsection Set width that keeps the stiffness
  set Key = Lumped DEMES/Frame width
  set Value = {0.010032*pre_stretch/2}
end
subsection Set no voltage
  set Key = Lumped DEMES/Source
  set Value = 0
end
subsection Result frequency
  set Of = modes/frequencies/0
end
""")
        self.run_study(0, study="modes.prm")
        found = [float(row["frequency"]) for row in self.read_table()]
        # The table of these frequencies has four digits.
        self.assertAlmostEqual(found[0], 5.704, delta=5e-3)
        self.assertAlmostEqual(found[1], 15.150, delta=5e-3)
        modes = (self.folder / "out/cases/pre_stretch=2/modes.csv").read_text(
            encoding="utf-8").splitlines()
        column = modes[0].split(",").index("frequency [Hz]")
        self.assertEqual(float(modes[1].split(",")[column]), found[0])
        # Without folders the same.
        self.run_study(0, "--set", "Keep folders = false", study="modes.prm",
                       folder="table")
        self.assertEqual([float(row["frequency"])
                          for row in self.read_table("table")], found)

    def test_films_run_like_lumped_cases(self):
        self.write("films.prm", FILM_STUDY.replace("VALUES", "0.01, 0.02"))
        self.run_study(0, study="films.prm")
        rows = self.read_table()
        self.expect(0, "run", "case.prm", "-o", "alone",
                    "--set", "Procedure/End time = 0.02")
        header, history = self.read_history("alone")
        self.assertEqual(float(rows[1]["lift [m]"]),
                         history[-1][header.index("lift [m]")])
        event = self.read_events("alone")[0]
        self.assertEqual(rows[1]["crossing [s]"], event["time [s]"])
        self.run_study(0, "--set", "Keep folders = false", study="films.prm",
                       folder="memory")
        for row, other in zip(self.read_table("memory"), rows):
            self.assertEqual(row["lift [m]"], other["lift [m]"])
            self.assertEqual(row["crossing [s]"], other["crossing [s]"])

    def test_a_dry_run_lists_the_cases_and_writes_nothing(self):
        said = self.run_study(0, "--dry-run").stdout.splitlines()
        self.assertEqual(len(said), 6)
        for part in ("4:", "pre_stretch = 2.5", "source = 5000", "2.5_5000"):
            self.assertIn(part, said[3])
        self.assertFalse((self.folder / "out").exists())

    def test_several_studies_share_a_folder(self):
        self.write("other.prm", STUDY.replace("2, 2.5, 3", "2"))
        self.expect(0, "study", "study.prm", "other.prm", "-o", "out")
        self.assertEqual(len(self.read_table("out/study")), 6)
        self.assertEqual(len(self.read_table("out/other")), 2)

    def test_the_plot_is_made_at_the_end_and_no_part_of_success(self):
        self.write("plot.py", "")
        self.write("python", "#!/bin/sh\n[ \"$1\" = -c ] && exit 0\n"
                   "cp \"$3/study.csv\" \"$3/plotted\"\nexit 7\n")
        (self.folder / "python").chmod(0o755)
        os.environ["TAUT_PYTHON"] = str(self.folder / "python")
        self.addCleanup(os.environ.pop, "TAUT_PYTHON")
        said = self.run_study(0, "--set", "Plot = plot.py").stdout
        self.assertIn("ended with code 7", said)
        self.assertEqual((self.folder / "out" / "plotted").read_text(),
                         (self.folder / "out" / "study.csv").read_text())


class Failures(StudyTest):
    def test_some_cases_fail_and_the_rest_goes_on(self):
        self.write("films.prm", FILM_STUDY.replace("VALUES", "0.01")
                   + "subsection Vary steps\n  set Values = 3, -1, 100000\n"
                   "  set Key = Procedure/Integrator/Most steps\nend\n")
        said = self.run_study(SOLVER_FAILED, "--set",
                              "Folder = steps_{steps}",
                              study="films.prm").stdout
        self.assertIn("1 of 3 done, 1 failed, 1 refused: see out/study.csv",
                      said)
        rows = self.read_table()
        self.assertEqual([row["status"] for row in rows],
                         ["failed", "refused", "completed"])
        self.assertIn("steps", rows[0]["reason"])
        self.assertIn("Most steps", rows[1]["reason"])
        self.assertEqual([row["lift [m]"] == "" for row in rows],
                         [True, True, False])
        counts = self.read_study()["cases"]
        self.assertEqual(counts, {"total": 3, "done": 1, "failed": 1,
                                  "refused": 1, "interrupted": 0})
        # Only what is asked for is done again.
        self.run_study(SOLVER_FAILED, study="films.prm",
                       *("--set", "Folder = steps_{steps}"))
        self.assertEqual(sorted(self.read_computed()), [1, 2, 3])
        self.run_study(SOLVER_FAILED, "--retry-failed", study="films.prm",
                       *("--set", "Folder = steps_{steps}"))
        self.assertEqual(sorted(self.read_computed()), [1, 1, 2, 2, 3])

    def test_a_fatal_event_is_an_end_like_others(self):
        self.write("films.prm", FILM_STUDY.replace("VALUES", "0.01")
                   + "subsection Set fatal\n  set Key = Event far/Fatal\n"
                   "  set Value = true\nend\n")
        self.run_study(0, study="films.prm")
        row = self.read_table()[0]
        self.assertEqual(row["status"], "event")
        self.assertLess(float(row["time reached [s]"]), 0.01)

    def test_an_impossible_result_stops_and_is_mended_without_a_new_run(self):
        wrong = STUDY.replace("set Of = angle\nend", "set Of = angel\nend")
        self.write("study.prm", wrong)
        line = 1 + wrong[:wrong.index("angel")].count("\n")
        self.expect_refused([f"study.prm:{line}", "Result last angle",
                             "did you mean 'angle'?"],
                            "study", "study.prm", "-o", "out", "--jobs", "1")
        self.assertEqual(self.read_computed(), [1])
        self.write("study.prm", STUDY)
        self.run_study(0, "--jobs", "1")
        # The first case is not computed again, only written down again.
        self.assertEqual(self.read_computed()[:2], [1, 1])
        self.run_study(0, folder="again")
        for row, other in zip(self.read_table(), self.read_table("again")):
            self.assertEqual(row["last angle [rad]"],
                             other["last angle [rad]"])

    def test_another_result_of_kept_runs_is_read_from_their_folders(self):
        self.run_study(0)
        before = (self.folder / "out/cases/2_2000/run.json").stat().st_mtime_ns
        self.run_study(0, "--set", "Result swing/From = 0.15")
        after = (self.folder / "out/cases/2_2000/run.json").stat().st_mtime_ns
        self.assertEqual(before, after)
        self.run_study(0, "--set", "Result swing/From = 0.15", folder="anew")
        for row, other in zip(self.read_table(), self.read_table("anew")):
            self.assertAlmostEqual(float(row["swing [rad]"]),
                                   float(other["swing [rad]"]), delta=1e-14)


class Refused(StudyTest):
    def refuse(self, fragments, *words):
        self.expect_refused(fragments, "study", "study.prm", "-o", "out",
                            *words)

    def test_a_key_that_does_not_exist(self):
        wrong = STUDY.replace("DEMES/Pre-stretch", "DEMES/Pre-strech")
        self.write("study.prm", wrong)
        self.refuse(["study.prm:5", "Vary pre_stretch/Key",
                     "did you mean 'Pre-stretch'?"])
        self.assertFalse((self.folder / "out").exists())

    def test_a_case_in_place_of_a_study_and_the_other_way_round(self):
        self.expect_refused(["lumped.prm:1", "taut run"], "study", "lumped.prm",
                            "-o", "out")
        self.expect_refused(["study.prm:1", "taut study"], "run", "study.prm",
                            "-o", "out")

    def test_an_empty_range(self):
        self.write("study.prm",
                   STUDY.replace("Values = 2, 2.5, 3", "Range = 2, 2, 3"))
        self.refuse(["study.prm:4", "an empty range"])

    def test_cases_with_the_same_folder(self):
        self.refuse(["cases 1 and 2", "the same folder '2'"],
                    "--set", "Folder = {pre_stretch}")

    def test_the_folder_of_another_study_unless_it_is_replaced(self):
        self.run_study(0)
        other = ("--set", "Vary source/Values = 2000")
        self.refuse(["another study", "'Vary source/Values' was "
                     "'2000, 5000' and is '2000'"], *other)
        self.write("lumped.prm", LUMPED.replace("49.9", "50"))
        self.refuse(["another study", "case file has changed in line 8"])
        self.run_study(0, "--overwrite", *other)
        self.assertEqual(len(self.read_table()), 3)
        # The folders of the old study are gone.
        self.assertEqual(len(list((self.folder / "out/cases").iterdir())), 3)

    def test_the_folder_of_a_run(self):
        self.expect(0, "run", "lumped.prm", "-o", "out")
        self.refuse(["holds a run"], "--overwrite")

    def test_more_ranks_than_one(self):
        self.expect_refused(["without mpirun"], "study", "study.prm", "-o",
                            "out", ranks=2)

    def test_workers_that_nobody_coordinates(self):
        result = self.expect(1, "work", "1")
        self.assertIn("taut study alone", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
