#!/usr/bin/env python3
"""Figures 3.2 and 3.10 of the thesis by finite elements, with the lumped model
beside them if its study stands beside this one.

Usage: resonator_film.py FOLDER
"""

import sys

import paper
from taut_plots import COLOURS, GREY, plt

EDGES = {"y": ("side edges follow", COLOURS[0], "-"),
         "x, y": ("side edges clamped", COLOURS[1], "--")}
NETWORKS = "0.01, 1, 100"
ON = 1000  # the voltage of figure 3.10 begins to rise (s)


def list_curves(study, lumped, share):
    """(label, colour, style, history) of every film and of the lumped model."""
    if lumped:
        values = {"share": 0.5} if share else {}
        case = lumped.get(times=NETWORKS, **values)
        yield "lumped", GREY, ":", lumped.read_history(case)
    for case in study.cases:
        label, colour, style = EDGES[case["edges"]]
        yield label, colour, style, study.read_history(case)


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
    return figure, curves


def mark_loss(panel, study, case):
    """Where the film first loses its tension."""
    time = case["first loss of tension"]
    if time != time:
        return
    history = study.read_history(case)
    voltage, stretch = (paper.np.interp(time, history["time"], history[name])
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
    return figure, curves


def main():
    study = paper.load(sys.argv)
    draw = draw_ramp if study.get_figure() == "3.2" else draw_evolution
    figure, curves = draw(study, study.find_sibling())
    handles = [paper.make_line(colour, label, style)
               for label, colour, style, _ in curves]
    if draw is draw_ramp:
        handles.append(plt.Line2D([], [], color="black", marker="x",
                                  linestyle="", markersize=4,
                                  label="first loss of tension"))
    paper.add_legend(figure, handles, columns=2)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
