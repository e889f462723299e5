#!/usr/bin/env python3
"""Figures 3.10, 3.11 and 3.12 of the thesis: the natural frequency of the
resonator in time, relaxed before its voltage rises to V* = 0.2.

Usage: resonator_evolution.py FOLDER
"""

import sys

import paper
from taut_plots import COLOURS, GREY, plt

ON = 1000  # the voltage begins to rise (s)
STYLES = ["-", "--", ":", "-."]


def list_curves(study):
    """(label, colour, style, history) of every case."""
    for index, case in enumerate(study.cases):
        if study.has("rate"):
            label = f"$r = {case['rate']:g}$ /s"
        else:
            times = case["times"]
            label = "$T = $" + (f"{times:g}" if isinstance(times, float)
                                else times) + " s"
        yield label, COLOURS[index], STYLES[index], study.read_history(case)


def draw_after(panel, curves):
    """From the beginning of the ramp on."""
    for _, colour, style, history in curves:
        after = history["time"] > ON
        panel.semilogx(history["time"][after] - ON,
                       history["natural frequency"][after] / paper.FREQUENCY,
                       style, color=colour)
    panel.set_xlim(0.02, 3000)
    panel.set_xlabel("time since the ramp began (s)")
    panel.set_ylabel(r"$\Omega_n$")


def draw_before(panel, curves):
    for _, colour, style, history in curves:
        before = history["time"] <= ON
        panel.plot(history["time"][before],
                   history["natural frequency"][before] / paper.FREQUENCY,
                   style, color=colour)
    panel.set_xlabel("time (s)")
    panel.set_ylabel(r"$\Omega_n$")
    panel.set_xlim(0, ON)


def draw_ramp(panel, curves):
    for _, colour, style, history in curves:
        time = history["time"]
        ramp = (time >= ON) & (time <= ON + 0.666667)
        panel.plot(history["voltage"][ramp] / paper.VOLTAGE,
                   history["natural frequency"][ramp] / paper.FREQUENCY,
                   style, color=colour)
    panel.set_xlabel(r"$V^*$ while it rises")
    panel.set_ylabel(r"$\Omega_n$")
    panel.set_xlim(0, 0.2)


def main():
    study = paper.load(sys.argv)
    curves = list(list_curves(study))
    if study.get_figure() == "3.10":
        figure, panels = plt.subplots(1, 3, figsize=(paper.DOUBLE, 2.4),
                                      layout="constrained")
        for panel, draw in zip(panels, (draw_before, draw_ramp, draw_after)):
            draw(panel, curves)
        paper.number_panels(panels)
    else:
        figure, panel = plt.subplots(figsize=(paper.SINGLE, 2.5),
                                     layout="constrained")
        draw_after(panel, curves)
        if study.has("rate"):
            draw_voltage(panel, curves)
    paper.add_legend(figure, [paper.make_line(colour, label, style)
                              for label, colour, style, _ in curves],
                     columns=2 if len(curves) == 4 else None)
    paper.save(figure, study)


def draw_voltage(panel, curves):
    """Faint, with an axis of its own."""
    right = panel.twinx()
    for _, _, style, history in curves:
        after = history["time"] > ON
        right.plot(history["time"][after] - ON,
                   history["voltage"][after] / paper.VOLTAGE, style,
                   color=GREY, linewidth=0.7, alpha=0.7)
    right.set_ylabel("$V^*$", color=GREY)
    right.spines["right"].set_visible(True)
    right.grid(False)
    right.set_ylim(0, 0.5)


if __name__ == "__main__":
    main()
