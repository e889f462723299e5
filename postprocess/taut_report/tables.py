"""CSV tables with the header `name [unit]`, read from whatever a run has left."""

import csv
import math
import re
from dataclasses import dataclass


@dataclass
class Column:
    """`values` are numbers if `is_number`, else text."""

    name: str
    unit: str
    values: list
    is_number: bool

    def is_empty(self):
        return self.is_number and all(math.isnan(v) for v in self.values)


def to_number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def make_column(title, texts):
    match = re.fullmatch(r"(.*) \[(.*)\]", title)
    given = [text for text in texts if text]
    is_number = bool(match) or bool(given) and all(
        not math.isnan(to_number(text)) for text in given)
    name, unit = match.groups() if match else (title, "")
    values = [to_number(text) for text in texts] if is_number else texts
    return Column(name, "" if unit == "1" else unit, values, is_number)


def read_table(file):
    """Columns in order; [] without the file. A last line that was cut short is
    left out."""
    if not file.is_file():
        return []
    with open(file, newline="", encoding="utf-8", errors="replace") as stream:
        rows = [row for row in csv.reader(stream) if row]
    if not rows:
        return []
    titles = rows[0]
    rows = [row for row in rows[1:] if len(row) == len(titles)]
    return [make_column(title, [row[i] for row in rows])
            for i, title in enumerate(titles)]


def find_column(columns, name):
    return next((column for column in columns if column.name == name), None)


def count_rows(columns):
    return len(columns[0].values) if columns else 0
