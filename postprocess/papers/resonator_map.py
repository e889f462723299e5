#!/usr/bin/env python3
"""Figure 3.15 of the thesis: shift of the resonator's natural frequency by
V* = 0.2 over both pre-stretches.

Usage: resonator_map.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import plt
from matplotlib.colors import TwoSlopeNorm


def get_shifts(study, ratio):
    """Both pre-stretches, and the shift over them; nan where the device fails."""
    rows, columns = (np.array(study.get_values(name))
                     for name in ("stretch_2", "stretch_1"))
    shifts = np.full((len(rows), len(columns)), np.nan)
    for case in study.select(ratio=ratio):
        if case["status"] == "completed":
            shift = case["frequency"] - case["frequency without voltage"]
            shifts[np.searchsorted(rows, case["stretch_2"] - 1e-9),
                   np.searchsorted(columns, case["stretch_1"] - 1e-9)] = \
                shift / paper.get_frequency(ratio)
    return columns, rows, shifts


def mark(panel, columns, rows, shifts, index, marker):
    """The place and the value of an extreme."""
    row, column = np.unravel_index(index, shifts.shape)
    panel.plot(columns[column], rows[row], marker, color="black", markersize=4,
               clip_on=False, zorder=5)
    return f"{shifts[row, column]:+.2f}"


def main():
    study = paper.load(sys.argv)
    ratios = study.get_values("ratio")
    maps = [get_shifts(study, ratio) for ratio in ratios]
    highest = max(np.nanmax(shifts) for _, _, shifts in maps)
    lowest = min(np.nanmin(shifts) for _, _, shifts in maps)
    levels = np.arange(-0.4, 2.41, 0.1)
    norm = TwoSlopeNorm(0, vmin=min(lowest, -0.4), vmax=highest)
    figure, axes = plt.subplots(1, len(ratios), sharey=True,
                                figsize=(paper.DOUBLE, 2.7),
                                layout="constrained")
    titles = []
    for panel, ratio, (columns, rows, shifts) in zip(axes, ratios, maps):
        panel.set_facecolor("#d9d9d9")
        drawn = panel.contourf(columns, rows, shifts, levels, norm=norm,
                               cmap="RdBu_r", extend="both")
        panel.contour(columns, rows, shifts, [0], colors="black",
                      linewidths=0.8)
        top = mark(panel, columns, rows, shifts, np.nanargmax(shifts), "^")
        bottom = mark(panel, columns, rows, shifts, np.nanargmin(shifts), "v")
        titles.append(f"$k = {ratio:g}$: {bottom} to {top}")
        panel.set_xlabel(r"$\lambda_{1p}$")
        panel.grid(False)
    axes[0].set_ylabel(r"$\lambda_{2p}$")
    bar = figure.colorbar(drawn, ax=axes, label=r"$\Delta\Omega$ at $V^* = 0.2$",
                          ticks=np.arange(-0.4, 2.5, 0.4))
    bar.outline.set_visible(False)
    paper.number_panels(axes, titles)
    patch = plt.Rectangle((0, 0), 1, 1, color="#d9d9d9")
    handles = [plt.Line2D([], [], color="black", marker="^", linestyle="",
                          markersize=4, label="highest"),
               plt.Line2D([], [], color="black", marker="v", linestyle="",
                          markersize=4, label="lowest"),
               paper.make_line("black", "no shift", width=0.8)]
    patch.set_label("fails")
    paper.add_legend(figure, handles + [patch])
    paper.save(figure, study)


if __name__ == "__main__":
    main()
