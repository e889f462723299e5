#!/usr/bin/env python3
"""Plots of the studies modes_resonator.prm and modes_demes.prm: frequencies of
vibration modes against the voltage.

Usage: modes.py FOLDER   (of the study)
Writes modes.png and .svg.
"""

import sys
from pathlib import Path

import study_table as table
from study_table import plots
from taut_plots import plt

MARKERS = ["o", "s", "D", "^", "v", "P"]
# Modes of the bar; film alone is far above.
BAR_MODES = ["up and down", "along x", "along y", "tilt", "turn in the plane"]
HALF = 0.5


def read_modes(folder, row):
    columns = plots.read_table(Path(folder) / row["folder"] / "modes.csv")
    names = [name for name, _, _ in columns]
    return [dict(zip(names, values))
            for values in zip(*(values for _, _, values in columns))]


def name_bar_mode(mode):
    """By the mass it moves; a tilt leaves the plane, so that no network damps
    it, a turn does not."""
    for axis, name in zip("zxy", BAR_MODES):
        if mode[f"share of mass {axis}"] > HALF:
            return name
    return BAR_MODES[3] if abs(mode["damping ratio"]) < 1e-6 else BAR_MODES[4]


def collect_resonator(voltages, cases):
    series = {name: [] for name in BAR_MODES}
    series["film alone"] = []
    for modes in cases:
        for mode in modes[:5]:
            series[name_bar_mode(mode)].append(mode["frequency"])
        series["film alone"].append(modes[5]["frequency"])
    if any(len(values) != len(voltages) for values in series.values()):
        raise SystemExit("modes of bar and film are mixed")
    return series


def collect_demes(voltages, cases):
    """The first two by the direction of their mass, the others by number."""
    series = {"ends together": [], "ends in opposition": []}
    for modes in cases:
        together = max(modes[:2], key=lambda mode: mode["share of mass z"])
        opposite = max(modes[:2], key=lambda mode: mode["share of mass x"])
        series["ends together"].append(together["frequency"])
        series["ends in opposition"].append(opposite["frequency"])
        for mode in modes[2:6]:
            name = f"modes {mode['mode']:.0f} and up"
            series.setdefault(name, []).append(mode["frequency"])
    return series


def draw(voltages, series, n_followed):
    """All frequencies; of the modes that are followed through crossings, also
    what the voltage leaves of their stiffness."""
    figure, axes = plt.subplots(1, 2, figsize=(6.8, 2.9),
                                layout="constrained")
    for place, (name, values) in enumerate(series.items()):
        followed = place < n_followed
        style = {"color": plots.COLOURS[place] if followed else plots.GREY,
                 "marker": MARKERS[place] if followed else ".",
                 "markersize": 3.5}
        first = place <= n_followed
        axes[0].plot(voltages, values, label=name if first else None, **style)
        if followed:
            axes[1].plot(voltages,
                         [(value / values[0]) ** 2 for value in values],
                         **style)
    axes[0].set_yscale("log")
    low = min(min(values) for values in series.values())
    high = max(max(values) for values in series.values())
    ticks = [tick for tick in (10, 15, 20, 30, 50, 70, 100, 150, 200, 300)
             if 0.9 * low <= tick <= 1.1 * high]
    axes[0].set_yticks(ticks, [str(tick) for tick in ticks])
    axes[0].minorticks_off()
    axes[0].set_ylabel("Frequency (Hz)")
    axes[1].set_ylabel("(Frequency/that without voltage)²")
    for panel in axes:
        panel.set_xlabel("Voltage (kV)")
    figure.legend(*axes[0].get_legend_handles_labels(), frameon=False,
                  loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=3)
    return figure


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    # An unstable state has modes without a frequency.
    rows = [row for row in table.read_study(folder)
            if row["status"] == "completed" and row["lowest square"] > 0]
    voltages = [row["kilovolts"] for row in rows]
    cases = [read_modes(folder, row) for row in rows]
    is_demes = "angle" in rows[0]
    collect = collect_demes if is_demes else collect_resonator
    plots.set_style()
    plots.save(draw(voltages, collect(voltages, cases), 2 if is_demes else 5),
               folder / "modes")


if __name__ == "__main__":
    main()
