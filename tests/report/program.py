"""Calls of taut in a folder of their own.

Every test of this folder is called with the path of taut and of the sources.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
CASES = SOURCE / "prm"


def call(*words, **environment):
    return subprocess.run(
        [PROGRAM, *map(str, words)], capture_output=True, text=True,
        env={**os.environ, **environment}, timeout=300, check=False)


def make_path_without(folder, *missing):
    """A PATH with all tools of the system but some."""
    folder.mkdir()
    for place in ("/usr/bin", "/bin"):
        for tool in os.listdir(place):
            if tool not in missing and not (folder / tool).is_symlink():
                (folder / tool).symlink_to(os.path.join(place, tool))
    return str(folder)


class FolderTest(unittest.TestCase):
    """`folder` is shared by the tests of a class."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="taut report "))
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    @classmethod
    def run_case(cls, case, name, *words, code=0):
        done = call("run", CASES / case, "-o", cls.folder / name, *words)
        assert done.returncode == code, done.stdout + done.stderr
        return cls.folder / name

    def expect(self, code, *words, **environment):
        result = call(*words, **environment)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result

    def expect_refused(self, fragments, *words, **environment):
        """Exit code 2 and one line that holds all fragments."""
        result = self.expect(2, *words, **environment)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertTrue(lines[0].startswith("taut: "), lines[0])
        for fragment in fragments:
            self.assertIn(fragment, lines[0])
