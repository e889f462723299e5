#!/usr/bin/env python3
"""Figures 3.2, 3.10 and 3.15 of the thesis by finite elements, with the lumped
model beside them if its study stands beside this one.

Usage: resonator_film.py FOLDER
"""

import sys

import numpy as np
import paper
from resonator_map import get_shifts
from taut_plots import COLOURS, GREY, plt

EDGES = {"y": ("side edges follow", COLOURS[0], "-"),
         "x, y": ("side edges clamped", COLOURS[1], "--")}
NETWORKS = "0.01, 1, 100"
ON = 1000  # the voltage of figure 3.10 begins to rise (s)
# Marks of figure 3.15 by its variable `clamped`.
EDGES_OF_SHIFTS = {0: ("finite elements, edges follow", "o"),
                   1: ("finite elements, edges clamped", "s")}


def list_curves(study, lumped, share):
    """(label, colour, style, history) of every film and of the lumped model."""
    if lumped:
        values = {"share": 0.5} if share else {}
        case = lumped.get(times=NETWORKS, **values)
        yield "lumped", GREY, ":", lumped.read_history(case)
    for case in study.cases:
        label, colour, style = EDGES[case["edges"]]
        yield label, colour, style, study.read_history(case)


def make_mark(label, marker, colour="black", fill="black"):
    return plt.Line2D([], [], linestyle="", markersize=4, label=label,
                      marker=marker, color=colour, markerfacecolor=fill)


def make_handles(curves):
    return [paper.make_line(colour, label, style)
            for label, colour, style, _ in curves]


def draw_ramp(study, lumped):
    figure, panel = plt.subplots(figsize=(paper.SINGLE, 2.6),
                                 layout="constrained")
    curves = list(list_curves(study, lumped, True))
    for label, colour, style, history in curves:
        panel.plot(history["voltage"] / paper.VOLTAGE,
                   history["stretch active"], style, color=colour,
                   linewidth=2.4 if label == "lumped" else 1.1)
    for case in study.cases:
        mark_loss(panel, study, case)
    panel.set_xlabel("$V^*$")
    panel.set_ylabel(r"$\lambda_{1A}$, mean over the strip")
    panel.set_xlim(left=0)
    return figure, make_handles(curves) + [
        make_mark("first loss of tension", "x")]


def mark_loss(panel, study, case):
    """Where the film first loses its tension."""
    time = case["first loss of tension"]
    if time != time:
        return
    history = study.read_history(case)
    voltage, stretch = (np.interp(time, history["time"], history[name])
                        for name in ("voltage", "stretch active"))
    panel.plot(voltage / paper.VOLTAGE, stretch, "x", markersize=4,
               color=EDGES[case["edges"]][1])


def draw_evolution(study, lumped):
    figure, panel = plt.subplots(figsize=(paper.SINGLE, 2.5),
                                 layout="constrained")
    curves = list(list_curves(study, lumped, False))
    for label, colour, style, history in curves:
        later = history["time"] > ON
        panel.semilogx(history["time"][later] - ON,
                       history["stretch active"][later], style, color=colour,
                       linewidth=2.4 if label == "lumped" else 1.1)
    panel.set_xlim(0.02, 3000)
    panel.set_xlabel("time since the ramp began (s)")
    panel.set_ylabel(r"$\lambda_{1A}$, mean over the strip")
    return figure, make_handles(curves)


def mark_shifts(panel, study, colour, **values):
    """The shifts over the pre-stretch along x: hollow where the film has lost its
    tension somewhere, a cross where no equilibrium is found."""
    label, marker = EDGES_OF_SHIFTS[values["clamped"]]
    unit = paper.get_frequency(values["ratio"])
    places, shifts = [], []
    for case in study.select(load=0.2, **values):
        place = case["stretch_1"]
        before = study.get(load=0, stretch_1=place, **values)
        places.append(place)
        shifts.append((case["frequency"] - before["frequency"]) / unit)
        taut = np.isnan(case["first loss of tension"])
        panel.plot(place, shifts[-1], marker, color=colour, markersize=4,
                   markerfacecolor=colour if taut else "white", zorder=4)
    if values["clamped"]:
        panel.plot(places, shifts, "--", color=colour, linewidth=0.7)


def draw_shifts(study, lumped):
    """Figure 3.15: cuts through the maps of the lumped model."""
    ratios = study.get_values("ratio")
    colours = dict(zip(study.get_values("stretch_2"), COLOURS))
    figure, axes = plt.subplots(1, len(ratios), sharey=True,
                                figsize=(paper.DOUBLE, 3),
                                layout="constrained")
    for panel, ratio in zip(axes, ratios):
        panel.axhline(0, color="black", linewidth=0.5)
        for stretch, colour in colours.items():
            if lumped:
                columns, rows, shifts = get_shifts(lumped, ratio)
                row = np.flatnonzero(np.isclose(rows, stretch))[0]
                panel.plot(columns, shifts[row], color=colour)
            for clamped in EDGES_OF_SHIFTS:
                mark_shifts(panel, study, colour, ratio=ratio,
                            stretch_2=stretch, clamped=clamped)
        panel.set_xlabel(r"$\lambda_{1p}$")
    axes[0].set_ylabel(r"$\Delta\Omega$ at $V^* = 0.2$")
    paper.number_panels(axes, [f"$k = {ratio:g}$" for ratio in ratios])
    handles = [paper.make_line(colour, "lumped, "
                               rf"$\lambda_{{2p}} = {stretch:g}$")
               for stretch, colour in colours.items()]
    handles += [make_mark(*edges) for edges in EDGES_OF_SHIFTS.values()]
    handles.append(make_mark("hollow: slack somewhere", "s", fill="white"))
    return figure, handles


DRAWINGS = {"3.2": draw_ramp, "3.10": draw_evolution, "3.15": draw_shifts}


def main():
    study = paper.load(sys.argv)
    draw = DRAWINGS[study.get_figure()]
    figure, handles = draw(study, study.find_sibling())
    paper.add_legend(figure, handles, columns=3 if draw is draw_shifts else 2)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
