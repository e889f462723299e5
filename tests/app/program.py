"""A small case in a folder of its own and the program that runs it.

Every test of this folder is called with the paths of taut and mpiexec.
"""

import csv
import json
import shutil
import subprocess
import sys
import tempfile
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
