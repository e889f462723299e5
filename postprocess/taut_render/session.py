"""Writes DIR/open_in_paraview.py, which shows in ParaView what the pictures show."""

from pathlib import Path

HEAD = '''"""Shows this run in ParaView: `paraview --script=open_in_paraview.py`, or in its Python
shell Run Script; also by pvpython and pvbatch."""

import os

SETTINGS = {settings!r}

'''
TAIL = '''

def find_fields():
    """Beside this script, wherever the folder was moved."""
    here = globals().get("__file__", "")
    beside = os.path.join(os.path.dirname(os.path.abspath(here)), "fields.pvd")
    return beside if os.path.exists(beside) else SETTINGS["fields"]


def open_run():
    source = pv.PVDReader(registrationName="run", FileName=find_fields())
    view = pv.GetActiveViewOrCreate("RenderView")
    show(source, view, SETTINGS["field"], SETTINGS["limits"],
         SETTINGS["mode_scale"])
    pv.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    pv.GetAnimationScene().GoToLast()
    pv.ResetCamera(view)
    pv.Render(view)


open_run()
'''


def write_session(folder, field, limits, is_modes):
    folder = Path(folder).resolve()
    macro = Path(__file__).resolve().parents[1] / "taut_macro.py"
    settings = {"fields": str(folder / "fields.pvd"), "field": field,
                "limits": None if is_modes else limits,
                "mode_scale": 1.0 if is_modes else 0.0}
    # The docstring of the macro is about macros.
    body = macro.read_text(encoding="utf-8").split('"""', 2)[2].lstrip()
    file = folder / "open_in_paraview.py"
    file.write_text(HEAD.format(settings=settings) + body + TAIL,
                    encoding="utf-8")
    return file
