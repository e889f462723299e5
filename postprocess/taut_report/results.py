"""What a folder holds; whatever is missing or broken is empty."""

import json
import re
from dataclasses import dataclass, field
from pathlib import Path

from .tables import read_table

UNIT = re.compile(r"\(([A-Za-z0-9/^*(). ]{1,14})\)$")


@dataclass
class Parameter:
    """Of parameters.prm: the value and, from its comment, the unit."""

    value: str
    unit: str


@dataclass
class Results:
    """A run: tables by the stem of their file."""

    folder: Path
    summary: dict
    parameters: dict
    log: list
    tables: dict = field(default_factory=dict)
    study: dict = field(default_factory=dict)
    comparison: dict = field(default_factory=dict)

    def get_parameter(self, key, default=""):
        found = self.parameters.get(key)
        return found.value if found else default

    def is_study(self):
        return bool(self.study) or bool(self.tables["study"])

    def is_response(self):
        """The history of a frequency response repeats its points."""
        return bool(self.tables["response"])

    def is_path(self):
        return any(column.name == "negative eigenvalues"
                   for column in self.tables["history"])


def read_text(file):
    if not file.is_file():
        return ""
    return file.read_text(encoding="utf-8", errors="replace")


def read_json(file):
    try:
        content = json.loads(read_text(file) or "{}")
    except json.JSONDecodeError:
        return {}
    return content if isinstance(content, dict) else {}


def find_unit(comments):
    match = UNIT.search(" ".join(comments))
    unit = match[1] if match else ""
    return "" if unit == "dimensionless" else unit


def read_parameters(text):
    """Section/Key to Parameter."""
    parameters, path, comments = {}, [], []
    for line in map(str.strip, text.splitlines()):
        if line.startswith("#"):
            comments.append(line[1:].strip())
            continue
        if line.startswith("subsection "):
            path.append(line[len("subsection "):])
        elif line == "end" and path:
            path.pop()
        elif line.startswith("set "):
            key, _, value = line[4:].partition("=")
            value = value.split(" # default:")[0].strip()
            parameters["/".join(path + [key.strip()])] = Parameter(
                value, find_unit(comments))
        comments = []
    return parameters


def read_results(folder):
    folder = Path(folder)
    stems = ("history", "events", "compare", "modes", "section", "spectrum",
             "response", "study")
    return Results(
        folder=folder,
        summary=read_json(folder / "run.json"),
        parameters=read_parameters(read_text(folder / "parameters.prm")),
        log=read_text(folder / "log.txt").splitlines(),
        tables={stem: read_table(folder / f"{stem}.csv") for stem in stems},
        study=read_json(folder / "study.json"),
        comparison=read_json(folder / "compare.json"))
