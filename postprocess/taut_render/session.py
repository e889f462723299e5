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
    folder = os.path.dirname(os.path.abspath(globals().get("__file__", "")))
    if not os.path.exists(os.path.join(folder, SETTINGS["fields"])):
        folder = SETTINGS["folder"]
    return os.path.join(folder, SETTINGS["fields"])


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


def write_session(folder, found, field, limits):
    folder = folder.resolve()
    macro = Path(__file__).resolve().parents[1] / "taut_macro.py"
    settings = {"folder": str(folder),
                "fields": str(found.source.resolve().relative_to(folder)),
                "field": field,
                "limits": None if found.is_modes else limits,
                "mode_scale": 1.0 if found.is_modes else 0.0}
    # The docstring of the macro is about macros.
    body = macro.read_text(encoding="utf-8").split('"""', 2)[2].lstrip()
    file = folder / "open_in_paraview.py"
    file.write_text(HEAD.format(settings=settings) + body + TAIL,
                    encoding="utf-8")
    return file
