"""What the plots of the studies share: tables of a study, events between two
load steps, and the lumped resonator at a slowly rising voltage."""

import csv
import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import taut_plots as plots  # noqa: E402

# Of prm/resonator: modulus (Pa), its share that always carries, limit of the
# Gent spring, thickness (m), permittivity (F/m).
MODULUS, SHARE, LIMIT, THICKNESS = 40e3, 0.5, 67.0, 1e-3
PERMITTIVITY = 4.7 * 8.8541878128e-12


def read_study(folder):
    """One dictionary a case; numbers where a field is one, nan where it is
    empty. Keys are the names without their units."""
    with open(Path(folder) / "study.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [{re.sub(r" \[[^]]*\]$", "", key): parse(value)
             for key, value in row.items()} for row in rows]


def parse(text):
    try:
        return float(text) if text else math.nan
    except ValueError:
        return text


def read_history(folder, row):
    columns = plots.read_table(Path(folder) / row["folder"] / "history.csv")
    return {name: values for name, _, values in columns}


def find_crossing(history, values, threshold=0.0):
    """The columns where `values` first fall to the threshold, linear between
    two rows; None if they do not."""
    for i in range(1, len(values)):
        if values[i - 1] > threshold >= values[i]:
            part = ((values[i - 1] - threshold)
                    / (values[i - 1] - values[i]))
            return {name: column[i - 1] + part * (column[i] - column[i - 1])
                    for name, column in history.items()}
    return None


def compute_spring(along, across):
    """Nominal stress along, over the modulus, of the spring that carries for
    ever; the width is held."""
    gap = LIMIT + 3 - along ** 2 - across ** 2 - (along * across) ** -2
    return (SHARE * LIMIT * (along - along ** -3 * across ** -2) / gap)


def compute_balance(along, p1, p2):
    """Square of the field number V/H sqrt(eps/G) that holds the active strip at
    a stretch; both strips are as long and relaxed."""
    other = 2 * p1 - along
    return ((compute_spring(along, p2) - compute_spring(other, p2))
            / (along * p2 ** 2))


def make_lumped_path(p1, p2, length=0.04, points=2000):
    """Voltage (V), true field (V/m) and displacement of the bar (m) up to the
    loss of tension, along or across; `length`: of a strip in the frame."""
    path = []
    end = 2 * p1 - p2 ** -0.5
    for i in range(points + 1):
        along = p1 + (end - p1) * i / points
        number = compute_balance(along, p1, p2)
        across = compute_spring(p2, along) - number * p2 * along ** 2
        if across < 0:
            break
        voltage = math.sqrt(number * MODULUS / PERMITTIVITY) * THICKNESS
        path.append((voltage, voltage / THICKNESS * along * p2,
                     (along / p1 - 1) * length))
    return path


def is_same(a, b):
    return math.isclose(a, b, rel_tol=1e-9)
