#!/usr/bin/env python3
"""Plots of the studies clamped_failure.prm, clamped_margin.prm and
bonded_failure.prm: first wrinkles and largest field next to the lumped models.

Usage: failure.py FOLDER   (of the study)
Writes failure.csv (voltage, field and place of the first wrinkles by case) and
failure.png and .svg.
"""

import csv
import math
import sys
from pathlib import Path

import study_table as table
from study_table import plots
from taut_plots import plt

# Of clamped_ramp.prm and bonded_ramp.prm (V/m).
STRENGTHS = {False: 75e6, True: 25e6}
# Of bonded_ramp.prm: voltage (V) at which V/H sqrt(eps/mu) = 1 without stretch.
UNIT_VOLTAGE = 5000 / 0.3
MARKERS = ["o", "s", "D", "^"]


def read_place(folder, row, event):
    """Film, x, y (m) of the first event of a name; None if there was none."""
    file = Path(folder) / row["folder"] / "events.csv"
    with open(file, newline="", encoding="utf-8") as stream:
        for found in csv.DictReader(stream):
            if found["event"] == event:
                return (found["place"], float(found["x [m]"]),
                        float(found["y [m]"]))
    return None


def is_bonded(row):
    return "stretch" in row


def get_field(history, strength):
    """Exceeded in the event's share of the film."""
    return [strength * (1 - margin) for margin in history["margin breakdown"]]


def complete(folder, row):
    """Adds what the history holds between its rows."""
    history = table.read_history(folder, row)
    history["field"] = get_field(history, STRENGTHS[is_bonded(row)])
    wrinkled = table.find_crossing(history, history["margin first wrinkles"])
    broken = table.find_crossing(history, history["margin breakdown"])
    nowhere = dict.fromkeys(history, math.nan)
    row["history"] = history
    row["wrinkled"] = wrinkled or nowhere
    row["broken"] = broken or nowhere
    row["place"] = read_place(folder, row, "first wrinkles") or ("", "", "")
    return row


def write_table(rows, variables, file):
    with open(file, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(variables + [
            "first wrinkles [kV]", "field [MV/m]", "breakdown at [kV]",
            "bar displacement [mm]", "film", "x [m]", "y [m]"])
        for row in rows:
            at = row["wrinkled"]
            writer.writerow(
                [f"{row[name]:g}" for name in variables]
                + [f"{at['time']:.3f}", f"{at['field'] / 1e6:.1f}",
                   f"{row['broken']['time']:.3f}",
                   f"{1e3 * at.get('bar displacement', math.nan):.2f}"]
                + list(row["place"]))


def choose(rows, **wanted):
    return [row for row in rows
            if all(table.is_same(row[name], value)
                   for name, value in wanted.items())]


def draw_series(axes, rows, abscissa, ordinate, style):
    """Coarse mesh as a line, fine one as a ring round its points."""
    for refined in (0, 1):
        chosen = choose(rows, refined=refined)
        axes.plot([row[abscissa] for row in chosen],
                  [ordinate(row) for row in chosen],
                  color=style["color"], marker=style["marker"],
                  linestyle="-" if refined else "", linewidth=1,
                  markersize=4 if refined else 8,
                  markerfacecolor=style["color"] if refined else "none",
                  markeredgewidth=0.8,
                  label=style["label"] if refined else None)


def draw_field(axes, rows):
    """Field against voltage, and where tension is lost."""
    row = choose(rows, ratio=2, p1=2, p2=4, refined=1)[0]
    until = row["wrinkled"]
    times = [t for t in row["history"]["time"] if t < until["time"]]
    fields = row["history"]["field"][:len(times)]
    axes.plot(times + [until["time"]],
              [field / 1e6 for field in fields + [until["field"]]],
              color=plots.COLOURS[0], label="clamped, largest")
    axes.plot(until["time"], until["field"] / 1e6, "o", markersize=4,
              color=plots.COLOURS[0])
    path = table.make_lumped_path(2, 4)
    axes.plot([voltage / 1e3 for voltage, _, _ in path],
              [field / 1e6 for _, field, _ in path], "--",
              color=plots.GREY, label="lumped, uniform")
    axes.plot(path[-1][0] / 1e3, path[-1][1] / 1e6, "o", markersize=4,
              color=plots.GREY)
    axes.set_xlim(3, 7.2)
    axes.set_ylim(0, None)
    axes.set_xlabel("Voltage (kV)")
    axes.set_ylabel("True field (MV/m)")
    axes.set_title("Pre-stretch 2, 4, width/length 2;\ndots: tension lost",
                   loc="left")
    axes.legend(frameon=False)


def draw_failure(rows):
    figure, axes = plt.subplots(1, 3, figsize=(7.4, 2.9),
                                layout="constrained")
    pairs = sorted({(row["p1"], row["p2"]) for row in rows})
    for (p1, p2), colour, marker in zip(pairs, plots.COLOURS, MARKERS):
        chosen = choose(rows, p1=p1, p2=p2)
        style = {"color": colour, "marker": marker, "label": f"{p1:g}, {p2:g}"}
        voltage, _, way = table.make_lumped_path(p1, p2)[-1]
        draw_series(axes[0], chosen, "ratio",
                    lambda row: row["wrinkled"]["time"], style)
        axes[0].axhline(voltage / 1e3, color=colour, linestyle="--",
                        linewidth=0.9)
        draw_series(axes[1], chosen, "ratio",
                    lambda row: 1e3 * row["wrinkled"]["bar displacement"],
                    style)
        axes[1].axhline(1e3 * way, color=colour, linestyle="--",
                        linewidth=0.9)
    for panel in axes[:2]:
        panel.set_xscale("log", base=2)
        panel.set_xticks([1, 2, 4], ["1", "2", "4"])
        panel.set_xlabel("Width/length of a strip")
    axes[0].set_ylim(0, None)
    axes[0].set_ylabel("Voltage where tension is lost (kV)")
    axes[1].set_ylabel("Displacement of the bar there (mm)")
    axes[1].set_yscale("log")
    axes[1].set_yticks([4, 10, 20, 40], ["4", "10", "20", "40"])
    axes[1].minorticks_off()
    axes[0].set_title("Pre-stretch along x, y;\ndashed: lumped", loc="left")
    axes[1].set_title("Rings: coarse mesh;\ndashed: lumped", loc="left")
    draw_field(axes[2], rows)
    handles, labels = axes[0].get_legend_handles_labels()
    axes[0].legend(handles, labels, frameon=False, ncol=2, loc="lower left",
                   title="pre-stretch")
    return figure


def draw_margin(rows):
    figure, axes = plt.subplots(1, 3, figsize=(7.4, 2.7),
                                layout="constrained")
    panels = [("Voltage of the first wrinkles (kV)",
               lambda row: row["wrinkled"]["time"]),
              ("Voltage where 75 MV/m are reached (kV)",
               lambda row: row["broken"]["time"]),
              ("Bar displacement at the first wrinkles (mm)",
               lambda row: 1e3 * row["wrinkled"]["bar displacement"])]
    gaps = sorted({row["gap"] for row in rows})
    for panel, (label, ordinate) in zip(axes, panels):
        for gap, colour, marker in zip(gaps, plots.COLOURS, MARKERS):
            draw_series(panel, choose(rows, gap=gap), "margin", ordinate,
                        {"color": colour, "marker": marker,
                         "label": f"{gap:g} mm"})
        panel.set_xlabel("Margin of the electrode (mm)")
        panel.set_ylabel(label)
    axes[0].legend(frameon=False, title="bar to frame")
    axes[1].set_title("Rings: coarse mesh", loc="left")
    return figure


def compute_uniform(stretch):
    """Voltage (V) at which the film of a flat DEMES, as wide as before it was
    stretched, has no tension across left: mu (1 - l^-2) is eps E^2 and the part
    of a permittivity that falls with the stretch."""
    x = stretch - 1
    law = 1 - 0.1658 * x + 0.04086 * x ** 2 - 0.00302754 * x ** 3
    slope = -0.1658 + 0.08172 * x - 0.00908262 * x ** 2
    return UNIT_VOLTAGE * math.sqrt((1 - stretch ** -2)
                                    / (stretch ** 2 * (law + slope / 2)))


def draw_bonded(rows):
    figure, axes = plt.subplots(1, 2, figsize=(6.2, 2.8), sharey=True,
                                layout="constrained")
    stretches = sorted({row["stretch"] for row in rows})
    for stretch, colour, marker in zip(stretches, plots.COLOURS, MARKERS):
        chosen = choose(rows, stretch=stretch)
        style = {"color": colour, "marker": marker, "label": f"{stretch:g}"}
        for panel, name in zip(axes, ("wrinkled", "broken")):
            draw_series(panel, chosen, "width",
                        lambda row: row[name]["time"], style)
        axes[0].axhline(compute_uniform(stretch) / 1e3, color=colour,
                        linestyle="--", linewidth=0.9)
    for panel in axes:
        panel.set_xscale("log")
        panel.set_xticks([0.7, 1, 1.5, 2.5], ["0.7", "1", "1.5", "2.5"])
        panel.minorticks_off()
        panel.set_xlabel("Width of the legs/that of K_bb = 1")
    axes[0].set_ylim(0, None)
    axes[0].set_ylabel("Voltage (kV)")
    axes[0].set_title("First wrinkles;\ndashed: flat, uniform film",
                      loc="left")
    axes[1].set_title("Field of 25 MV/m reached;\nrings: coarse mesh",
                      loc="left")
    axes[1].legend(frameon=False, title="pre-stretch", ncol=3)
    return figure


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    folder = Path(sys.argv[1])
    rows = [complete(folder, row) for row in table.read_study(folder)]
    if is_bonded(rows[0]):
        variables, draw = ["stretch", "width"], draw_bonded
    elif "gap" in rows[0]:
        variables, draw = ["margin", "gap"], draw_margin
    else:
        variables, draw = ["ratio", "p1", "p2"], draw_failure
    plots.set_style()
    write_table(rows, variables + ["refined"], folder / "failure.csv")
    plots.save(draw(rows), folder / "failure")


if __name__ == "__main__":
    main()
