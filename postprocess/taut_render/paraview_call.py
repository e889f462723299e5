"""Calls ParaView without a screen."""

import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from .refusal import Refusal

NEEDED = {"pvbatch": "python3-paraview paraview", "xvfb-run": "xvfb",
          "xauth": "xauth"}
PACKAGES = "paraview python3-paraview xvfb xauth"
HOW_TO_GET_IT = ("install it by `apt install --no-install-recommends "
                 f"{PACKAGES}`, or call ./taut render, which does")


def find_missing():
    return [tool for tool in NEEDED if shutil.which(tool) is None]


def check_paraview():
    missing = find_missing()
    if missing:
        raise Refusal("pictures are drawn by ParaView, and "
                      f"{' and '.join(missing)} cannot be found: "
                      f"{HOW_TO_GET_IT}")


def make_environment():
    """Without what would make pvbatch a rank of the caller's."""
    begins = ("OMPI_COMM_WORLD", "OMPI_UNIVERSE", "PMIX_", "PMI_")
    return {key: value for key, value in os.environ.items()
            if not key.startswith(begins)}


def draw(plan):
    """Draws the shots of a plan (see draw.py); what was found out."""
    check_paraview()
    script = Path(__file__).with_name("draw.py")
    with tempfile.TemporaryDirectory(prefix="taut_plan_") as folder:
        file = Path(folder) / "plan.json"
        file.write_text(json.dumps(plan), encoding="utf-8")
        words = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "pvbatch",
                 str(script), str(file)]
        done = subprocess.run(words, capture_output=True, text=True,
                              env=make_environment(),
                              stdin=subprocess.DEVNULL, check=False)
        result = file.with_name("plan.json.done")
        if not result.is_file():
            said = (done.stdout + done.stderr).strip() or "nothing"
            said = "\n".join(said.splitlines()[-12:])
            raise RuntimeError(f"ParaView drew nothing; it said:\n{said}")
        return json.loads(result.read_text(encoding="utf-8"))
