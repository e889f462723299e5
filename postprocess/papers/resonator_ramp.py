#!/usr/bin/env python3
"""Figures 3.2 to 3.9 of the thesis: stretch of the active strip, or natural
frequency, of the resonator while its voltage rises to the failure.

Usage: resonator_ramp.py FOLDER
"""

import sys

import paper
from taut_plots import COLOURS, plt

STRETCHES = {"3.2", "3.4", "3.6", "3.8"}
STYLES = ["-", "--", ":"]


def name_networks(times):
    """The relaxation times as a set."""
    text = f"{times:g}" if isinstance(times, float) else times
    return r"$T = $" + text + " s"


def draw(panel, study, name, factor):
    shares = study.get_values("share")
    networks = study.get_values("times")
    for case in study.cases:
        history = study.read_history(case)
        colour = COLOURS[shares.index(case["share"])]
        voltage = history["voltage"] / paper.VOLTAGE
        panel.plot(voltage, factor * history[name], color=colour,
                   linestyle=STYLES[networks.index(case["times"])])
        panel.plot(voltage[-1], factor * history[name][-1], "x", color=colour,
                   markersize=4)
    handles = [paper.make_line(COLOURS[index], rf"$\chi = {share:g}$")
               for index, share in enumerate(shares)]
    handles += [paper.make_line("black", name_networks(times), STYLES[index])
                for index, times in enumerate(networks)]
    handles.append(plt.Line2D([], [], color="black", marker="x", markersize=4,
                              linestyle="", label="failure"))
    return handles


def main():
    study = paper.load(sys.argv)
    figure, panel = plt.subplots(figsize=(paper.SINGLE, 2.7),
                                 layout="constrained")
    if study.get_figure() in STRETCHES:
        handles = draw(panel, study, "stretch active", 1)
        panel.set_ylabel(r"$\lambda_{1A}$")
    else:
        handles = draw(panel, study, "natural frequency", 1 / paper.FREQUENCY)
        panel.set_ylabel(r"$\Omega_n$")
    panel.set_xlabel(r"$V^*$")
    panel.set_xlim(left=0)
    paper.add_legend(figure, handles, columns=3)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
