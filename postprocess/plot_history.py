#!/usr/bin/env python3
"""Plots the history of a run: one panel for every unit.

Usage: plot_history.py FOLDER
Reads FOLDER/history.csv, writes history.png and history.svg. Columns that stay
zero are left out.
"""

import sys
from pathlib import Path

import taut_plots as plots
from taut_plots import plt

# Later lines leave gaps through which equal ones are seen.
STYLES = ["-", "--", "-.", ":"]
MARGIN = "margin to failure"


def group_by_unit(columns):
    """Columns that are not zero throughout, by unit in order of appearance.

    The margins of events stand together, below numbers without a unit.
    """
    groups = {}
    for name, unit, values in columns:
        if plots.largest(values) > 0:
            key = MARGIN if name.startswith("margin ") else unit
            groups.setdefault(key, []).append((name, values))
    return groups


def plot_group(axes, times, unit, group):
    factor, label = (1.0, MARGIN) if unit == MARGIN else plots.choose_prefix(
        unit, [value for _, values in group for value in values])
    for index, (name, values) in enumerate(group):
        axes.plot(times, [factor * value for value in values],
                  STYLES[index % len(STYLES)],
                  color=plots.COLOURS[index % len(plots.COLOURS)], label=name)
    axes.set_ylabel(label or "dimensionless")
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)


def make_figure(columns):
    times = columns[0][2]
    groups = group_by_unit(columns[1:])
    if not groups:
        raise SystemExit("history.csv has nothing but zeros")
    heights = [max(1.5, 0.19 * len(group)) for group in groups.values()]
    figure, axes = plt.subplots(len(groups), 1, sharex=True, squeeze=False,
                                figsize=(7.2, sum(heights) + 0.4),
                                height_ratios=heights, layout="constrained")
    for row, (unit, group) in zip(axes[:, 0], groups.items()):
        plot_group(row, times, unit, group)
    axes[-1, 0].set_xlabel("Time (s)")
    axes[0, 0].set_xlim(times[0], times[-1])
    return figure


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    columns = plots.read_table(folder / "history.csv")
    plots.set_style()
    plots.save(make_figure(columns), folder / "history")


if __name__ == "__main__":
    main()
