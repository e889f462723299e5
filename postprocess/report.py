#!/usr/bin/env python3
"""One HTML page about a run or a study that needs no other file and no network;
this is what `taut report` calls.

Pictures are drawn first if the run has fields and none were drawn since it ended
(see render.py); without ParaView the page says how to get it.
"""

import argparse
import sys
from pathlib import Path

import render
from taut_render import paraview_call
from taut_render.refusal import Refusal
from taut_report.page import make_page
from taut_report.results import read_results


def have_pictures(folder):
    """Drawn, and later than the run."""
    pictures = folder / "pictures" / "pictures.json"
    fields = folder / "fields.pvd"
    return (pictures.is_file()
            and pictures.stat().st_mtime >= fields.stat().st_mtime)


def draw_pictures(folder):
    """Empty, or why there are none."""
    missing = paraview_call.find_missing()
    if missing:
        return ("There are no pictures: they are drawn by ParaView, and "
                f"{' and '.join(missing)} cannot be found. "
                f"{paraview_call.HOW_TO_GET_IT}; then make this report again."
                .replace(". install", ". Install"))
    try:
        render.render(render.parse_words([str(folder)]))
    except (Refusal, RuntimeError, OSError) as error:
        return f"There are no pictures: {error}."
    return ""


def report(folder, output, draws):
    folder = Path(folder)
    problem = ""
    if draws and (folder / "fields.pvd").is_file() and not have_pictures(
            folder):
        problem = draw_pictures(folder)
    output = Path(output or folder / "report.html")
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(make_page(read_results(folder), problem),
                      encoding="utf-8")
    print(f"report in {output}")


def main(words):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", metavar="DIR")
    parser.add_argument("-o", "--output", metavar="FILE")
    parser.add_argument("--no-pictures", action="store_true")
    arguments = parser.parse_args(words)
    try:
        report(arguments.folder, arguments.output, not arguments.no_pictures)
    except OSError as error:
        print(f"taut: the report cannot be written: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
