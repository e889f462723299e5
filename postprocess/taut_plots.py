"""What the plots of Taut share: tables, units and style."""

import csv
import math
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# Okabe and Ito, "Color universal design" (2008): told apart by colour-blind
# readers, too. The yellow is left out, it is too pale for lines on white.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
           "#000000"]
GREY = "#6e6e6e"

PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}


def set_style():
    """Sizes for a figure of the width of a page, text that stays text."""
    plt.rcParams.update({
        "font.family": "DejaVu Sans",
        "font.size": 8,
        "axes.titlesize": 8,
        "axes.labelsize": 8,
        "xtick.labelsize": 7,
        "ytick.labelsize": 7,
        "legend.fontsize": 8,
        "axes.linewidth": 0.6,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.grid": True,
        "grid.color": "#e4e4e4",
        "grid.linewidth": 0.5,
        "lines.linewidth": 1.2,
        "lines.solid_capstyle": "round",
        "svg.fonttype": "none",
        "savefig.dpi": 200,
    })


def read_table(file):
    """Columns of a CSV with the header `name [unit]`, in order:
    a list of (name, unit, values); empty fields become nan."""
    with open(file, newline="", encoding="utf-8") as stream:
        rows = list(csv.reader(stream))
    columns = []
    for index, title in enumerate(rows[0]):
        match = re.fullmatch(r"(.*) \[(.*)\]", title)
        if not match:
            raise SystemExit(f"{file}: the column '{title}' has no unit")
        values = [float(row[index]) if row[index] else math.nan
                  for row in rows[1:]]
        columns.append((match[1], match[2], values))
    return columns


def largest(values):
    """The largest magnitude, 0 if there is no number."""
    return max((abs(value) for value in values if not math.isnan(value)),
               default=0.0)


def choose_prefix(unit, values):
    """A factor and a label such that the numbers on the axis are short."""
    top = largest(values)
    if unit == "1" or top == 0:
        return 1.0, "" if unit == "1" else unit
    exponent = 3 * math.floor(math.log10(top) / 3)
    exponent = min(max(exponent, min(PREFIXES)), max(PREFIXES))
    return 10.0 ** -exponent, PREFIXES[exponent] + unit


def make_label(name, unit):
    """"Charge (nC)"; pure numbers go without a unit."""
    text = name[:1].upper() + name[1:]
    return f"{text} ({unit})" if unit else text


def save(figure, stem, suffixes=("png", "svg")):
    """Writes the figure to stem.png, stem.svg, ..."""
    for suffix in suffixes:
        figure.savefig(f"{stem}.{suffix}", bbox_inches="tight")
    plt.close(figure)
