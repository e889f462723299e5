#!/usr/bin/env python3
"""Plots of the studies frequency_*.prm: what a lumped model misses of the lowest
frequency.

Usage: frequency.py FOLDER   (of one of the studies)
Draws frequency.png and .svg there. That of frequency_clamped needs the folder
frequency_lumped beside it.
"""

import math
import sys
from pathlib import Path

import study_table as table
from study_table import plots
from taut_plots import plt

MARKERS = ["o", "s", "D", "^"]
UNIT_FREQUENCY = 5.0  # Hz of the model of one angle at omega = 1
# Exact for massless legs without eccentricity, K_bb = 1, relaxed film: the legs
# are elasticas. Pre-stretch: angular frequency over that unit.
ELASTICA = {2: 1.000, 2.5: 1.416, 3: 1.624, 4: 1.828}


def find_lumped(lumped, **wanted):
    return next(row["frequency"] for row in lumped
                if all(table.is_same(row[name], value)
                       for name, value in wanted.items()))


def draw_clamped(rows, folder):
    lumped = table.read_study(folder.parent / "frequency_lumped")
    figure, axes = plt.subplots(1, 2, figsize=(6.6, 2.9),
                                layout="constrained")
    pairs = sorted({(row["p1"], row["p2"]) for row in rows})
    for (p1, p2), colour, marker in zip(pairs, plots.COLOURS, MARKERS):
        pair = {"p1": p1, "p2": p2}
        chosen = [row for row in rows if (row["p1"], row["p2"]) == (p1, p2)]
        still = [row for row in chosen if row["kilovolts"] == 0]
        axes[0].plot([row["ratio"] for row in still],
                     [100 * (row["frequency"]
                             / find_lumped(lumped, kilovolts=0, **pair) - 1)
                      for row in still], color=colour, marker=marker,
                     markersize=4, label=f"{p1:g}, {p2:g}")
        if (p1, p2) != (2, 4):
            continue
        path = [row for row in lumped if (row["p1"], row["p2"]) == (p1, p2)]
        rest = path[0]["frequency"]
        axes[1].plot([row["kilovolts"] for row in path],
                     [row["frequency"] / rest for row in path], "--",
                     color=plots.GREY, label="lumped")
        for ratio, shade in zip((8, 2, 1), plots.COLOURS):
            some = [row for row in chosen if row["ratio"] == ratio]
            axes[1].plot([row["kilovolts"] for row in some],
                         [row["frequency"] / some[0]["frequency"]
                          for row in some], color=shade, marker="s",
                         markersize=4, label=f"width/length {ratio}")
    axes[0].set_xscale("log", base=2)
    axes[0].set_yscale("log")
    axes[0].set_xticks([0.6, 1, 2, 4, 8], ["0.6", "1", "2", "4", "8"])
    axes[0].set_yticks([1, 2, 5, 10, 20, 50, 100],
                       ["1", "2", "5", "10", "20", "50", "100"])
    axes[0].minorticks_off()
    axes[0].set_xlabel("Width/length of a strip")
    axes[0].set_ylabel("Frequency above the lumped one (%)")
    axes[0].legend(frameon=False, title="pre-stretch x, y")
    axes[1].set_xlabel("Voltage (kV)")
    axes[1].set_ylabel("Frequency/that without voltage")
    axes[1].set_title("Pre-stretch 2, 4", loc="left")
    axes[1].legend(frameon=False)
    return figure


def find_wave_number(ratio):
    """Lowest root of z tan z = 2 M/m, `ratio` = m/M."""
    low, high = 0.0, math.pi / 2
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle * math.tan(middle) * ratio < 2:
            low = middle
        else:
            high = middle
    return low


def draw_wave(rows):
    figure, axes = plt.subplots(figsize=(3.6, 2.8), layout="constrained")
    lumped = {row["ratio"]: row["frequency"] for row in rows
              if row["cells"] == 1}
    fine = [row for row in rows if row["cells"] > 1]
    ratios = [10 ** (-2 + 3.7 * i / 100) for i in range(101)]
    axes.plot(ratios,
              [100 * (math.sqrt(2 / (ratio + 2 / 3))
                      / find_wave_number(ratio) - 1) for ratio in ratios],
              color=plots.GREY, label="exact: z tan z = 2 M/m")
    axes.plot([row["ratio"] for row in fine],
              [100 * (lumped[row["ratio"]] / row["frequency"] - 1)
               for row in fine], "o", color=plots.COLOURS[0], markersize=4,
              label="12 cells a strip")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_yticks([0.001, 0.01, 0.1, 1, 10],
                    ["0.001", "0.01", "0.1", "1", "10"])
    axes.minorticks_off()
    axes.set_xlabel("Mass of the bar/mass of a strip")
    axes.set_ylabel("Lumped frequency too high by (%)")
    axes.legend(frameon=False)
    return figure


def compute_arc(stretch, stiffness):
    """Relaxed rest angle and angular frequency, over their units, of the model
    of one angle (frame an arc, film neo-Hookean of held width) without voltage;
    stiffness = K_bb. Flat below the buckling load."""
    def geometry(angle):
        if angle < 1e-4:
            return 1 - angle ** 2 / 6, -angle / 3, -1 / 3
        sine, cosine = math.sin(angle), math.cos(angle)
        return (sine / angle, (angle * cosine - sine) / angle ** 2,
                -sine / angle - 2 * cosine / angle ** 2
                + 2 * sine / angle ** 3)

    def find_moment(angle):
        f, slope, _ = geometry(angle)
        length = stretch * f
        return (stiffness * angle
                + stretch * slope * (length - length ** -3))

    low, high = 1e-3, 3.0
    if find_moment(low) > 0:
        low = high = 0.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = ((middle, high) if find_moment(middle) < 0
                     else (low, middle))
    f, slope, bend = geometry(low)
    length = stretch * f
    square = (stiffness + (1 + 3 * length ** -4) * (stretch * slope) ** 2
              + (length - length ** -3) * stretch * bend)
    return low, math.sqrt(max(square, 0))


def draw_demes(rows):
    figure, axes = plt.subplots(1, 2, figsize=(6.6, 2.9), sharey=True,
                                layout="constrained")
    widths = [0.5 * 5 ** (i / 120) for i in range(121)]
    stretches = sorted({row["stretch"] for row in rows})
    for stretch, colour, marker in zip(stretches, plots.COLOURS, MARKERS):
        some = [row for row in rows if row["stretch"] == stretch]
        axes[0].plot([row["width"] for row in some],
                     [row["together"] for row in some], color=colour,
                     marker=marker, markersize=4, label=f"{stretch:g}")
        axes[0].plot(widths, [UNIT_FREQUENCY * compute_arc(stretch, width)[1]
                              for width in widths], "--", color=colour,
                     linewidth=0.9)
        axes[0].plot(1, UNIT_FREQUENCY * ELASTICA[stretch], "+",
                     color=colour, markersize=9, zorder=4)
        axes[1].plot([row["width"] for row in some],
                     [row["opposite"] for row in some], color=colour,
                     marker=marker, markersize=4)
    axes[0].set_title("Ends together; dashed: arc of one angle,\n"
                      "cross: legs as elasticas", loc="left")
    axes[1].set_title("Ends in opposition:\nno lumped counterpart",
                      loc="left")
    for panel in axes:
        panel.set_xscale("log")
        panel.set_xticks([0.5, 0.7, 1, 1.4, 2, 2.5],
                         ["0.5", "0.7", "1", "1.4", "2", "2.5"])
        panel.minorticks_off()
        panel.set_xlabel("Width of the legs/that of K_bb = 1")
    axes[0].set_ylabel("Frequency (Hz)")
    axes[1].tick_params(labelleft=True)
    axes[0].set_ylim(0, None)
    handles, labels = axes[0].get_legend_handles_labels()
    axes[1].legend(handles, labels, frameon=False, title="pre-stretch",
                   loc="upper left", ncol=2)
    return figure


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1]).resolve()
    rows = table.read_study(folder)
    plots.set_style()
    if "kilovolts" in rows[0]:
        figure = draw_clamped(rows, folder)
    elif "cells" in rows[0]:
        figure = draw_wave(rows)
    else:
        figure = draw_demes(rows)
    plots.save(figure, folder / "frequency")


if __name__ == "__main__":
    main()
