"""Calls ParaView without a screen."""

import contextlib
import json
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from .refusal import Refusal

NEEDED = ("pvbatch", "Xvfb")
PACKAGES = "paraview python3-paraview xvfb"
HOW_TO_GET_IT = ("install it by `apt install --no-install-recommends "
                 f"{PACKAGES}`, or call ./taut render, which does")
SCREEN = "1280x1024x24"


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


@contextlib.contextmanager
def open_screen():
    """The DISPLAY of a screen in memory, without which pvbatch does not start.
    The server finds a free number itself, also if many are started at once, and
    stays as it is between two clients, else the second may find it closed."""
    reading, writing = os.pipe()
    with open(os.devnull, "wb") as nothing, subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", SCREEN,
             "-nolisten", "tcp", "-noreset"], pass_fds=(writing,), stdout=nothing,
            stderr=nothing) as server:
        os.close(writing)
        try:
            with open(reading, encoding="ascii") as answer:
                number = answer.readline().strip()
            if not number:
                raise RuntimeError("Xvfb, ParaView's screen, did not start")
            yield f":{number}"
        finally:
            server.terminate()


def run_script(*words):
    """Calls pvbatch with a script and its words."""
    check_paraview()
    with open_screen() as display:
        return subprocess.run(
            ["pvbatch", *map(str, words)], capture_output=True, text=True,
            env={**make_environment(), "DISPLAY": display},
            stdin=subprocess.DEVNULL, check=False)


def draw(plan):
    """Draws the shots of a plan (see drawing.py); what was found out."""
    script = Path(__file__).with_name("draw.py")
    with tempfile.TemporaryDirectory(prefix="taut_plan_") as folder:
        file = Path(folder) / "plan.json"
        file.write_text(json.dumps(plan), encoding="utf-8")
        done = run_script(script, file)
        result = file.with_name("plan.json.done")
        if not result.is_file():
            said = (done.stdout + done.stderr).strip() or "nothing"
            said = "\n".join(said.splitlines()[-12:])
            raise RuntimeError(f"ParaView drew nothing; it said:\n{said}")
        return json.loads(result.read_text(encoding="utf-8"))
