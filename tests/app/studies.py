"""A small lumped case and a study of it, for the tests of taut study."""

import csv
import json
import os
import signal
import subprocess
import time
from pathlib import Path

from program import PROGRAM, AppTest

LUMPED = """set Model = demes
subsection Lumped DEMES
  set Film length = 0.02
  set Film width = 0.04
  set Film thickness = 5e-4
  set Pre-stretch = 2
  set Shear modulus = 52246.6
  set Viscosity = 49.9
  set Frame modulus = 2e9
  set Frame width = 0.010032
  set Frame thickness = 5e-4
  set Inertia = 2.117476e-5
  set Source = 5000
end
subsection Procedure
  set End time = 0.2
end
subsection Output
  set History intervals = 20
end
"""

STUDY = """set Case = lumped.prm
set Folder = {pre_stretch}_{source}
subsection Vary pre_stretch
  set Values = 2, 2.5, 3
  set Key = Lumped DEMES/Pre-stretch
end
subsection Vary source
  set Values = 2000, 5000
end
subsection Set source
  set Key = Lumped DEMES/Source
  set Value = {source}
end
subsection Result last angle
  set Of = angle
end
subsection Result swing
  set Of = angle
  set Statistic = amplitude
  set From = 0.1
end
"""

# Films whose runs are as long as their end times.
FILM_STUDY = """set Case = case.prm
set Folder = until_{end}
subsection Vary end
  set Values = VALUES
  set Key = Procedure/End time
end
subsection Result lift
  set Of = lift
end
subsection Result crossing
  set Of = event far
  set Statistic = time
end
"""


class StudyTest(AppTest):
    def setUp(self):
        super().setUp()
        self.write("lumped.prm", LUMPED)
        self.write("study.prm", STUDY)

    def run_study(self, code, *words, study="study.prm", folder="out"):
        return self.expect(code, "study", study, "-o", folder, *words)

    def read_table(self, folder="out"):
        file = self.folder / folder / "study.csv"
        with open(file, newline="", encoding="utf-8") as stream:
            return list(csv.DictReader(stream))

    def read_study(self, folder="out"):
        text = (self.folder / folder / "study.json").read_text(encoding="utf-8")
        return json.loads(text)

    def read_computed(self, folder="out"):
        """Numbers of the cases in the journal, in the order of their ends."""
        text = (self.folder / folder / "journal.jsonl").read_text(
            encoding="utf-8")
        lines = [json.loads(line) for line in text.splitlines(True)
                 if line.endswith("\n")]
        return [line["case"] for line in lines if "case" in line]

    def assert_same_tables(self, first, second):
        def without_seconds(rows):
            return [{key: value for key, value in row.items()
                     if key != "seconds [s]"} for row in rows]
        self.assertEqual(without_seconds(first), without_seconds(second))

    def start_study(self, *words, study="study.prm", folder="out"):
        process = subprocess.Popen(
            [PROGRAM, "study", study, "-o", folder, *words], cwd=self.folder,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_until(self, is_true, process):
        for _ in range(2000):
            if is_true():
                return
            if process.poll() is not None:
                self.fail("ended too early: " + process.stdout.read())
            time.sleep(0.01)
        self.fail("waited in vain")


def find_workers(process):
    """Their process ids; MPI may have children of its own."""
    file = f"/proc/{process.pid}/task/{process.pid}/children"
    with open(file, encoding="utf-8") as stream:
        children = [int(child) for child in stream.read().split()]
    return [child for child in children
            if b"work" in Path(f"/proc/{child}/cmdline").read_bytes()
            .split(b"\0")]


def end_at_once(pid):
    os.kill(pid, signal.SIGKILL)
