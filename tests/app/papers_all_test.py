#!/usr/bin/env python3
"""All lumped studies of prm/papers and the claims that they decide.

Usage: papers_all_test.py PROGRAM SOURCE_FOLDER
"""

import csv
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
CLAIMS = SOURCE / "postprocess" / "papers" / "claims.py"
# Debian's, for which its matplotlib and numpy are.
PYTHON = "/usr/bin/python3"


class AllPapers(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="taut papers "))
        self.addCleanup(shutil.rmtree, self.folder)

    def call(self, *words):
        done = subprocess.run(list(map(str, words)), cwd=self.folder,
                              capture_output=True, text=True, timeout=1000,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_documented_verdicts_are_those_of_the_studies(self):
        studies = sorted((SOURCE / "prm" / "papers").glob("*_[0-9][0-9].prm"))
        self.call(PROGRAM, "study", *studies)
        self.call(PYTHON, "-B", CLAIMS, "results")
        for study in studies:
            for suffix in ("png", "svg", "pdf"):
                figure = self.folder / "results" / study.stem / f"figure.{suffix}"
                self.assertGreater(figure.stat().st_size, 5000, figure)
        with open(self.folder / "results" / "claims.csv", newline="",
                  encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([row["paper"] for row in rows],
                         ["DEMES"] * 37 + ["resonator"] * 27)
        text = (SOURCE / "docs" / "claims.md").read_text(encoding="utf-8")
        documented = re.findall(r"\| \*\*(.*)\*\* \|$", text, re.MULTILINE)
        self.assertEqual([row["verdict"] for row in rows], documented)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
