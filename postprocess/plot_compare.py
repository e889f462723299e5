#!/usr/bin/env python3
"""Plots what `taut compare` wrote: the histories of every quantity in all models
and, of a resonator, their difference.

Usage: plot_compare.py FOLDER
Reads FOLDER/compare.csv and compare.json, writes compare.png and compare.svg.
"""

import json
import sys
from pathlib import Path

import taut_plots as plots
from taut_plots import plt

FILM, LUMPED = plots.COLOURS[:2]


def pair_quantities(columns):
    """(name, unit, film, lumped) from the columns behind time and voltage."""
    for film, lumped in zip(columns[2::2], columns[3::2]):
        yield film[0].removesuffix(" film"), film[1], film[2], lumped[2]


def mark_failures(axes, failures):
    for time, colour in failures:
        axes.axvline(time, color=colour, linewidth=0.8, linestyle=":")


def plot_voltage(axes, times, voltage, unit):
    factor, label = plots.choose_prefix(unit, voltage)
    axes.plot(times, [factor * value for value in voltage], color=plots.GREY)
    axes.set_ylabel(label)
    axes.set_title("Voltage", loc="left")


def plot_histories(axes, times, quantity):
    name, unit, film, lumped = quantity
    factor, label = plots.choose_prefix(unit, film + lumped)
    for values, colour, style in ((film, FILM, "-"), (lumped, LUMPED, "--")):
        axes.plot(times, [factor * value for value in values], style,
                  color=colour)
    axes.set_title(name[:1].upper() + name[1:], loc="left")
    axes.set_ylabel(label or "dimensionless")


def plot_difference(axes, times, quantity, until):
    """Film less lumped over the largest lumped value, while both count."""
    _, _, film, lumped = quantity
    count = [time <= until for time in times]
    scale = plots.largest([value for value, counts in zip(lumped, count)
                           if counts])
    difference = [(a - b) / scale if counts else float("nan")
                  for a, b, counts in zip(film, lumped, count)]
    axes.plot(times, difference, color=plots.COLOURS[2], linewidth=0.9)
    axes.axhline(0, color=plots.GREY, linewidth=0.5)
    axes.ticklabel_format(axis="y", style="sci", scilimits=(-2, 2),
                          useMathText=True)
    axes.yaxis.get_offset_text().set_size(7)
    axes.locator_params(axis="y", nbins=3)
    axes.set_ylabel("rel. diff.")


def add_legend(figure, failures):
    lines = [plt.Line2D([], [], color=FILM, label="finite elements"),
             plt.Line2D([], [], color=LUMPED, linestyle="--",
                        label="lumped model"),
             plt.Line2D([], [], color=plots.COLOURS[2],
                        label="difference / largest lumped value")]
    if failures:
        lines.append(plt.Line2D([], [], color=plots.GREY, linestyle=":",
                                label="failure"))
    figure.legend(handles=lines, loc="lower center", ncol=len(lines),
                  frameon=False, bbox_to_anchor=(0.5, 1.0))


def make_figure(columns, comparison):
    times, voltage = columns[0][2], columns[1]
    quantities = list(pair_quantities(columns))
    events = comparison["events"]
    failures = [(events[key]["time"], colour)
                for key, colour in (("lumped_failure", LUMPED),
                                    ("film_failure", FILM)) if events[key]]
    n_rows = (len(quantities) + 2) // 2
    figure = plt.figure(figsize=(7.2, 1.85 * n_rows), layout="constrained")
    grid = figure.add_gridspec(2 * n_rows, 2, height_ratios=(2.2, 1) * n_rows)
    first = figure.add_subplot(grid[0:2, 0])
    plot_voltage(first, times, voltage[2], voltage[1])
    everything, bottom = [first], [first]
    for place, quantity in enumerate(quantities, start=1):
        row, column = divmod(place, 2)
        top = figure.add_subplot(grid[2 * row, column], sharex=first)
        low = figure.add_subplot(grid[2 * row + 1, column], sharex=first)
        plot_histories(top, times, quantity)
        plot_difference(low, times, quantity, comparison["compared_until"])
        top.tick_params(labelbottom=False)
        everything += [top, low]
        bottom.append(low)
    for axes in bottom[-2:]:
        axes.set_xlabel("Time (s)")
    for axes in everything:
        mark_failures(axes, failures)
    figure.align_ylabels(everything[:1] + everything[3::4] + everything[4::4])
    figure.align_ylabels(everything[1::4] + everything[2::4])
    # A failure at the end must not hide in the frame.
    margin = 0.02 * (times[-1] - times[0]) if failures else 0
    first.set_xlim(times[0], times[-1] + margin)
    add_legend(figure, failures)
    return figure


# Of a DEMES, in the order of drawing, with the style of their lines.
DEMES_MODELS = {"arc": (plots.COLOURS[1], "--"),
                "elastica": (plots.COLOURS[2], "-."),
                "finite elements": (plots.COLOURS[0], "-")}


def get_demes_histories(columns, name):
    """Unit and {model: values} of a quantity."""
    models = {column[0].removeprefix(name + " "): column for column in columns
              if column[0].startswith(name + " ")}
    unit = next(iter(models.values()))[1]
    return unit, {model: column[2] for model, column in models.items()}


def plot_demes_quantity(axes, times, columns, name, title):
    unit, histories = get_demes_histories(columns, name)
    # An angle in rad is short as it is.
    factor, label = (1.0, unit) if unit == "rad" else plots.choose_prefix(
        unit, sum(histories.values(), []))
    for model, (colour, style) in DEMES_MODELS.items():
        axes.plot(times, [factor * value for value in histories[model]], style,
                  color=colour)
    axes.set_title(title, loc="left")
    axes.set_ylabel(label or "dimensionless")


def make_demes_figure(columns):
    """Voltage, angle, chord and stretch above one another."""
    times, voltage = columns[0][2], columns[1]
    figure, rows = plt.subplots(
        4, 1, figsize=(7.2, 7.0), sharex=True, layout="constrained",
        height_ratios=(0.6, 1.2, 1, 1))
    plot_voltage(rows[0], times, voltage[2], voltage[1])
    for axes, name, title in ((rows[1], "angle", "Half angle"),
                              (rows[2], "chord", "Chord"),
                              (rows[3], "stretch", "Stretch of the film")):
        plot_demes_quantity(axes, times, columns, name, title)
    rows[-1].set_xlabel("Time (s)")
    rows[0].set_xlim(times[0], times[-1])
    figure.align_ylabels(rows)
    lines = [plt.Line2D([], [], color=colour, linestyle=style, label=model)
             for model, (colour, style) in reversed(DEMES_MODELS.items())]
    figure.legend(handles=lines, loc="lower center", ncol=len(lines),
                  frameon=False, bbox_to_anchor=(0.5, 1.0))
    return figure


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    columns = plots.read_table(folder / "compare.csv")
    comparison = json.loads(
        (folder / "compare.json").read_text(encoding="utf-8"))
    plots.set_style()
    figure = (make_demes_figure(columns) if "models" in comparison
              else make_figure(columns, comparison))
    plots.save(figure, folder / "compare")


if __name__ == "__main__":
    main()
