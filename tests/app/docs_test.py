#!/usr/bin/env python3
"""Every command in the documentation, run as it stands or on a reduced case.

Usage: docs_test.py PROGRAM SOURCE_FOLDER
"""

import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM, SOURCE = sys.argv[1], Path(sys.argv[2]).resolve()
PAGES = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md",
         *sorted((SOURCE / "docs").glob("*.md"))]

# Commands begin like this, on a line of their own or between backticks.
COMMAND = r"(?:\./taut|python3|xvfb-run|cmake|podman|mpirun|build/)\s*\S.*"

# Not run here, and why.
ELSEWHERE = {
    r"\./taut (test|build|benchmark|clean|help)\b": "the door, tests/door",
    r"\./taut( |$)(?!\w)": "its name alone",
    r"podman|cmake|build/|mpirun": "how to build and measure",
    r".*(\b(CASE|STUDY)\.prm|\bDIR\b|\bSCRIPT\b|\[)": "how a command is called",
}

# What makes a command short enough for a test: words added to it.
REDUCED = {
    r"\./taut (run|compare|modes) prm/demes/dc\.prm":
        "--set 'Procedure/End time = 0.05' --set 'Output/Field intervals = 1'",
    r"\./taut compare prm/resonator/clamped\.prm":
        "--set 'Procedure/End time = 0.02'",
    r"\./taut run docs/tutorial/finger\.prm -o":
        "--set 'Procedure/Load steps = 2'",
    r"\./taut study docs/tutorial/finger_study\.prm":
        "--set 'Vary thickness/Range = 2.8e-4, 3.2e-4, 2'",
    r"\./taut study prm/papers": "--dry-run",
    r"\./taut study prm/studies/(?!pre_stretch)": "--dry-run",
    r"\./taut render": "--frames 1 --size 400x300",
}


def find_commands(page):
    """Commands of a page in their order, without the comments behind them."""
    text = page.read_text(encoding="utf-8").replace("\\\n", " ")
    lines = re.findall(rf"^(?:    |)({COMMAND})$|`({COMMAND}?)`", text,
                       re.MULTILINE)
    return [re.sub(r"\s{2,}\(.*", "", line or quoted).replace(r"\|", "|")
            for line, quoted in lines]


def match(rules, command):
    return next((value for rule, value in rules.items()
                 if re.match(rule, command)), None)


class Documentation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="taut docs "))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        for name in ("docs", "meshes", "postprocess", "prm"):
            (cls.folder / name).symlink_to(SOURCE / name)
        (cls.folder / "taut").symlink_to(Path(PROGRAM).resolve())

    def run_command(self, command):
        # matplotlib belongs to Debian's Python.
        command = re.sub(r"^python3 ", "/usr/bin/python3 -B ", command)
        words = shlex.split(command + " " + (match(REDUCED, command) or ""))
        done = subprocess.run(words, cwd=self.folder, capture_output=True,
                              text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_every_command_runs(self):
        ran = set()
        for page in PAGES:
            for command in find_commands(page):
                if command in ran or match(ELSEWHERE, command):
                    continue
                ran.add(command)
                with self.subTest(page=page.name, command=command):
                    self.run_command(command)
        self.assertGreater(len(ran), 8)

    def test_parameters_page_is_what_the_program_describes(self):
        page = subprocess.run([PROGRAM, "describe", "--markdown"],
                              capture_output=True, text=True, check=True)
        self.assertEqual(
            page.stdout,
            (SOURCE / "docs" / "parameters.md").read_text(encoding="utf-8"),
            "write it anew: ./taut describe --markdown > docs/parameters.md")

    def test_links_and_pictures_exist(self):
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            for target in re.findall(r"\]\((?!https?:)([^)#\s]*)", text):
                with self.subTest(page=page.name, target=target):
                    self.assertTrue((page.parent / target).exists())

    def test_equations_of_the_theory_are_counted_once(self):
        text = (SOURCE / "docs" / "theory.md").read_text(encoding="utf-8")
        numbers = re.findall(r"^ .*\S\s+\(([A-Z]?\d+)\)$", text, re.MULTILINE)
        self.assertGreater(len(numbers), 20)
        self.assertEqual(len(numbers), len(set(numbers)), sorted(numbers))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
