#!/usr/bin/env python3
"""Cases a second of `taut study` for short lumped cases.

Usage: study_rate.py PROGRAM [CASES]

Runs a DEMES of half a second with 50 rows for CASES (10000) pairs of pre-stretch
and voltage, once without and, for a tenth of them, once with the folders of the
runs. The goal is 200 a second on two cores without folders.
"""

import sys
import tempfile
import time
import subprocess
from pathlib import Path

CASE = Path(__file__).resolve().parents[1] / "prm" / "demes" / "lumped.prm"
STUDY = f"""set Case = {CASE}
set Keep folders = KEEP
set Folder = {{case}}
subsection Vary pre_stretch
  set Range = 1.5, 3.5, COUNT
  set Key = Lumped DEMES/Pre-stretch
end
subsection Vary volts
  set Range = 0, 5000, 10
  set Key = Lumped DEMES/Source
end
subsection Set end
  set Key = Procedure/End time
  set Value = 0.5
end
subsection Set rows
  set Key = Output/History intervals
  set Value = 50
end
subsection Result angle
  set Of = angle
end
"""


def measure(program, cases, keep):
    with tempfile.TemporaryDirectory() as folder:
        study = Path(folder) / "study.prm"
        study.write_text(STUDY.replace("KEEP", "true" if keep else "false")
                         .replace("COUNT", str(cases // 10)))
        start = time.perf_counter()
        subprocess.run([program, "study", study, "-o", Path(folder) / "out"],
                       stdout=subprocess.DEVNULL, check=True)
        seconds = time.perf_counter() - start
    print(f"{'with' if keep else 'without'} folders: {cases} cases in "
          f"{seconds:.1f} s, {cases / seconds:.0f} a second")


def main():
    program = sys.argv[1]
    cases = int(sys.argv[2]) if len(sys.argv) > 2 else 10000
    measure(program, cases, keep=False)
    measure(program, max(20, cases // 10), keep=True)


if __name__ == "__main__":
    main()
