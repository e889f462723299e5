#!/usr/bin/env python3
"""taut study that is killed, asked to stop, or loses a worker, and goes on.

Usage: study_stops_test.py PROGRAM MPIEXEC
"""

import os
import signal
import sys
import time
import unittest

from studies import FILM_STUDY, STUDY, StudyTest, end_at_once, find_workers

SOLVER_FAILED, INTERRUPTED = 3, 5
MANY = STUDY.replace("Values = 2, 2.5, 3", "Range = 2, 3, 200")


def is_alive(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="utf-8") as stream:
            return stream.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


class Killed(StudyTest):
    def test_a_killed_study_goes_on_as_if_nothing_had_happened(self):
        self.write("study.prm", MANY)
        process = self.start_study("--jobs", "2")
        journal = self.folder / "out" / "journal.jsonl"
        self.wait_until(lambda: journal.exists()
                        and len(self.read_computed()) > 20, process)
        workers = find_workers(process)
        end_at_once(process.pid)
        process.wait()
        # They must not write where the next call does.
        for _ in range(500):
            if not any(is_alive(worker) for worker in workers):
                break
            time.sleep(0.01)
        self.assertFalse(any(is_alive(worker) for worker in workers))
        before = set(self.read_computed())
        self.assertLess(len(before), 400)
        self.run_study(0, "--jobs", "2")
        computed = self.read_computed()
        self.assertEqual(sorted(computed), list(range(1, 401)))
        self.run_study(0, "--jobs", "1", folder="whole")
        self.assert_same_tables(self.read_table(), self.read_table("whole"))

    def test_two_studies_do_not_work_in_one_folder(self):
        self.write("study.prm", MANY)
        process = self.start_study("--jobs", "1")
        journal = self.folder / "out" / "journal.jsonl"
        self.wait_until(lambda: journal.exists()
                        and len(self.read_computed()) > 0, process)
        self.expect_refused(["another `taut study` is at work"], "study",
                            "study.prm", "-o", "out")


class Films(StudyTest):
    def setUp(self):
        super().setUp()
        # The second one takes much longer than the others.
        self.write("films.prm", FILM_STUDY.replace("VALUES", "0.01, 2, 0.02"))

    def start_until_long(self, *words):
        process = self.start_study("--jobs", "1", *words, study="films.prm")
        history = self.folder / "out/cases/until_2/history.csv"
        self.wait_until(lambda: history.exists()
                        and len(history.read_text().splitlines()) > 3, process)
        return process

    def test_a_worker_that_dies_loses_its_case_alone(self):
        process = self.start_until_long()
        end_at_once(find_workers(process)[0])
        said = process.communicate(timeout=60)[0]
        self.assertEqual(process.returncode, SOLVER_FAILED, said)
        self.assertIn("2 of 3 done, 1 failed", said)
        rows = self.read_table()
        self.assertEqual([row["status"] for row in rows],
                         ["completed", "failed", "completed"])
        self.assertIn("signal 9", rows[1]["reason"])

    def test_an_interrupted_study_goes_on_from_its_checkpoint(self):
        process = self.start_until_long()
        process.send_signal(signal.SIGTERM)
        said = process.communicate(timeout=60)[0]
        self.assertEqual(process.returncode, INTERRUPTED, said)
        self.assertIn("interrupted", said)
        rows = self.read_table()
        self.assertEqual([row["status"] for row in rows],
                         ["completed", "interrupted"])
        reached = float(rows[1]["time reached [s]"])
        self.assertGreater(reached, 0)
        self.assertLess(reached, 2)
        self.assertTrue((self.folder
                         / "out/cases/until_2/checkpoint/state").exists())
        self.assertEqual(self.read_study()["status"], "interrupted")
        self.run_study(0, study="films.prm")
        rows = self.read_table()
        self.assertEqual([row["status"] for row in rows], 3 * ["completed"])
        self.assertIn("going on from", (
            self.folder / "out/cases/until_2/log.txt").read_text())
        # The crossing lies before the interruption.
        self.assertLess(float(rows[1]["crossing [s]"]), reached)
        self.expect(0, "run", "case.prm", "-o", "alone",
                    "--set", "Procedure/End time = 2")
        header, history = self.read_history("alone")
        lift = [row[header.index("lift [m]")] for row in history]
        own = self.read_history("out/cases/until_2")[1]
        self.assertEqual(len(own), len(history))
        # Both have the local error of the integrator, 1e-6 of the lift's size
        # a step, and the restart is one more.
        self.assertAlmostEqual(float(rows[1]["lift [m]"]), lift[-1],
                               delta=1e-3 * max(lift))


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    unittest.main(argv=sys.argv[:1])
