#!/usr/bin/env python3
"""Plots the motion of a run: time, phase path, section and spectrum.

Usage: plot_motion.py FOLDER
Reads history.csv, section.csv, spectrum.csv and run.json of a run whose case
has a section Motion; writes motion.png and motion.svg into the folder.
"""

import json
import sys
from pathlib import Path

import taut_plots as plots
from taut_plots import plt

# More of a long history would be a block of ink.
LAST_SWINGS = 40
DECADES = 8


def read_column(columns, name):
    for column, unit, values in columns:
        if column == name:
            return unit, values
    raise SystemExit(f"there is no column '{name}'")


def differentiate(times, values):
    """Central differences, one-sided at the ends."""
    last = len(times) - 1
    slopes = []
    for i in range(len(times)):
        before, after = max(i - 1, 0), min(i + 1, last)
        slopes.append((values[after] - values[before])
                      / (times[after] - times[before]))
    return slopes


def get_rates(history, motion, times, values):
    """The velocity that the run wrote, or the slope of its rows."""
    name = motion.get("velocity")
    return read_column(history, name)[1] if name else differentiate(
        times, values)


def plot_time(axes, times, values, factor, label, begin):
    axes.plot(times, [factor * v for v in values], color=plots.COLOURS[0],
              linewidth=0.7)
    axes.axvspan(times[0], begin, color="#e4e4e4", linewidth=0)
    axes.set_xlim(times[0], times[-1])
    axes.set_xlabel("Time (s)")
    axes.set_ylabel(label)


def plot_path(axes, path, section, scales, labels):
    value, rate = scales
    axes.plot([value * v for v in path[0]], [rate * v for v in path[1]],
              color=plots.GREY, linewidth=0.5)
    axes.plot([value * v for v in section[0]], [rate * v for v in section[1]],
              ".", color=plots.COLOURS[1], markersize=4, label="section")
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    axes.legend(loc="upper right", frameon=False)


def widen(limits, least):
    """At least so wide about the same middle."""
    low, high = limits
    missing = max(least - (high - low), 0)
    return low - missing / 2, high + missing / 2


def plot_section(axes, path, section, scales, labels):
    """Early points are pale. Less than a hundredth of the path is a point."""
    points = axes.scatter([scales[0] * v for v in section[0]],
                          [scales[1] * v for v in section[1]],
                          c=list(range(len(section[0]))), cmap="cividis_r",
                          s=7, linewidths=0)
    axes.figure.colorbar(points, ax=axes, label="Number of the point")
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    least = [0.01 * scale * (max(values) - min(values))
             for scale, values in zip(scales, path)]
    axes.set_xlim(widen(axes.get_xlim(), least[0]))
    axes.set_ylim(widen(axes.get_ylim(), least[1]))
    axes.locator_params(nbins=4)
    axes.ticklabel_format(useOffset=False)


def plot_spectrum(axes, spectrum, factor, label):
    frequencies = spectrum[0][2][1:]
    amplitudes = [factor * a for a in spectrum[1][2][1:]]
    top = max(amplitudes, default=0)
    if top > 0:
        axes.semilogy(frequencies, amplitudes, color=plots.COLOURS[0],
                      linewidth=0.7)
        axes.set_ylim(top * 10.0 ** -DECADES, 2 * top)
    axes.set_xlabel("Frequency (Hz)")
    axes.set_ylabel(f"Amplitude: {label[:1].lower()}{label[1:]}")


def make_title(motion):
    """The class of the motion and the numbers that stand behind it."""
    title = motion["class"].capitalize()
    if motion["class"] == "periodic":
        title += (f", period {motion['period_number']}"
                  f" ({motion['period']:.4g} s)")
    if "lyapunov_exponent" in motion:
        title += (f"; largest Lyapunov exponent"
                  f" {motion['lyapunov_exponent']:.3g}"
                  f" ± {motion['lyapunov_uncertainty']:.1g} 1/s")
    if not motion.get("reproducible", True):
        title += (f"; not reproducible after"
                  f" {motion['reproducible_until']:.4g} s")
    return title


def make_figure(folder):
    with open(folder / "run.json", encoding="utf-8") as stream:
        motion = json.load(stream).get("motion")
    if not motion:
        raise SystemExit(f"{folder}: the case of this run has no section "
                         "Motion")
    history = plots.read_table(folder / "history.csv")
    section = plots.read_table(folder / "section.csv")
    times = history[0][2]
    unit, values = read_column(history, motion["of"])
    rates = get_rates(history, motion, times, values)
    value_factor, value_unit = plots.choose_prefix(unit, values)
    rate_factor, rate_unit = plots.choose_prefix(section[2][1], rates)
    labels = [plots.make_label(motion["of"], value_unit),
              plots.make_label(f"rate of {motion['of']}", rate_unit)]
    begin = motion["from"]
    kept = [i for i, t in enumerate(times) if t >= begin]
    swings = motion["dominant_frequency"] * (times[-1] - begin)
    shown = kept[-max(int(len(kept) * min(1, LAST_SWINGS / max(swings, 1))),
                      2):]
    scales = (value_factor, rate_factor)
    points = (section[1][2], section[2][2])
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 5.2),
                                layout="constrained")
    plot_time(axes[0, 0], times, values, value_factor, labels[0], begin)
    path = [values[i] for i in shown], [rates[i] for i in shown]
    plot_path(axes[0, 1], path, points, scales, labels)
    plot_section(axes[1, 0], path, points, scales, labels)
    plot_spectrum(axes[1, 1], plots.read_table(folder / "spectrum.csv"),
                  value_factor, labels[0])
    figure.suptitle(make_title(motion), fontsize=9)
    return figure


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    plots.set_style()
    plots.save(make_figure(folder), folder / "motion")


if __name__ == "__main__":
    main()
