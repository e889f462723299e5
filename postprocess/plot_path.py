#!/usr/bin/env python3
"""Plots a path of equilibria that `taut run` followed by continuation: stable
parts as lines, unstable ones dashed, jumps of a device dotted; limit points,
bifurcations and landings are marked.

Usage: plot_path.py FOLDER [ABSCISSA ORDINATE]
Reads FOLDER/history.csv and events.csv, writes path.png and path.svg. Abscissa
and ordinate are columns of the history, or `parameter`, the time of the signals; without them
every probe is shown against the parameter.
"""

import csv
import itertools
import math
import sys
from pathlib import Path

import taut_plots as plots
from taut_plots import plt

MARKS = {"limit_point": ("o", "limit point"),
         "bifurcation": ("s", "bifurcation"),
         "landing": ("v", "landing after a jump")}
STYLES = {"stable": "-", "unstable": "--", "jump": ":"}
# Of a path: where the energies begin, the columns of probes end.
AFTER_PROBES = "kinetic energy"


def read_marks(file):
    """(kind, parameter) of the special points, in the order of the path."""
    with open(file, newline="", encoding="utf-8") as stream:
        return [(row["kind"], float(row["time [s]"]))
                for row in csv.DictReader(stream) if row["kind"] in MARKS]


def is_same(a, b):
    return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12)


def place_marks(marks, parameters):
    """Kinds by row of the history: each mark has its row, later than the one
    of the mark before."""
    rows, row = {}, 0
    for kind, parameter in marks:
        found = next((i for i in range(row, len(parameters))
                      if is_same(parameters[i], parameter)), None)
        # A special point within a jump has no row.
        if found is not None:
            rows[found] = kind
            row = found + 1
    return rows


def classify(row, parameters, kinds, unstable):
    """How the way from the row before to this one is drawn."""
    if kinds.get(row) == "landing" and is_same(parameters[row - 1],
                                               parameters[row]):
        return "jump"
    # At a critical point the eigenvalues are those before it.
    return "unstable" if unstable[row] else "stable"


def plot_curve(axes, x, y, kinds, ways):
    """`ways`: how each row is reached from the one before."""
    start = 0
    for style, group in itertools.groupby(ways):
        end = start + len(list(group))
        axes.plot(x[start:end + 1], y[start:end + 1], STYLES[style],
                  color=plots.GREY if style == "jump" else plots.COLOURS[0])
        start = end
    for row, kind in kinds.items():
        axes.plot(x[row], y[row], MARKS[kind][0], color=plots.COLOURS[1],
                  markersize=4, zorder=3)


def plot_panel(axes, abscissa, ordinate, kinds, ways):
    scaled = []
    for name, unit, values in (abscissa, ordinate):
        factor, label = plots.choose_prefix(unit, values)
        scaled.append(([factor * value for value in values],
                       plots.make_label(name, label)))
    (x, x_label), (y, y_label) = scaled
    plot_curve(axes, x, y, kinds, ways)
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)


def add_legend(figure, kinds, ways):
    lines = [plt.Line2D([], [], linestyle=STYLES[way], label=way,
                        color=plots.GREY if way == "jump" else
                        plots.COLOURS[0])
             for way in STYLES if way in ways]
    for kind, (marker, label) in MARKS.items():
        if kind in kinds.values():
            lines.append(plt.Line2D([], [], color=plots.COLOURS[1],
                                    marker=marker, markersize=4,
                                    linestyle="", label=label))
    figure.legend(handles=lines, loc="lower center", ncol=len(lines),
                  frameon=False, bbox_to_anchor=(0.5, 1.0))


def choose_panels(columns, wanted):
    """Pairs of columns to be plotted."""
    # The time of a path is its parameter.
    columns = [("parameter", "s", columns[0][2])] + columns[1:]
    names = [name for name, _, _ in columns]
    if wanted:
        for name in wanted:
            if name not in names:
                raise SystemExit(f"there is no column '{name}'; there are "
                                 + ", ".join(names))
        return [tuple(columns[names.index(name)] for name in wanted)]
    return [(columns[0], column)
            for column in columns[1:names.index(AFTER_PROBES)]]


def make_figure(columns, marks, wanted):
    by_name = {name: values for name, _, values in columns}
    if "negative eigenvalues" not in by_name:
        raise SystemExit("history.csv is not of a continuation")
    unstable = [value > 0 for value in by_name["negative eigenvalues"]]
    parameters = columns[0][2]
    kinds = place_marks(marks, parameters)
    ways = [classify(row, parameters, kinds, unstable)
            for row in range(1, len(parameters))]
    panels = choose_panels(columns, wanted)
    if not panels:
        raise SystemExit("history.csv has no probe")
    figure, axes = plt.subplots(len(panels), 1, squeeze=False,
                                figsize=(5, 2.8 * len(panels) + 0.4),
                                layout="constrained")
    for row, (abscissa, ordinate) in zip(axes[:, 0], panels):
        plot_panel(row, abscissa, ordinate, kinds, ways)
    add_legend(figure, kinds, ways)
    return figure


def main():
    if len(sys.argv) not in (2, 4):
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    columns = plots.read_table(folder / "history.csv")
    marks = read_marks(folder / "events.csv")
    plots.set_style()
    plots.save(make_figure(columns, marks, sys.argv[2:]), folder / "path")


if __name__ == "__main__":
    main()
