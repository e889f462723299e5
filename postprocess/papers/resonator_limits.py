#!/usr/bin/env python3
"""Figures 3.13 and 3.14 of the thesis: voltages at which the resonator fails
and that it can hold, and the range in which they tune it, over their rate.

Usage: resonator_limits.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import COLOURS, GREY, plt


def draw_voltages(study):
    rates, failure = study.get_curve("rate", "failure voltage")
    hold = study.get_curve("rate", "hold limit")[1]
    figure, (voltages, ratio) = plt.subplots(
        1, 2, figsize=(paper.DOUBLE, 2.5), layout="constrained")
    voltages.semilogx(rates, failure / paper.VOLTAGE, "o-", color=COLOURS[1],
                      markersize=3, label="$V_f^*$, failure on the ramp")
    voltages.semilogx(rates, hold / paper.VOLTAGE, "s--", color=COLOURS[0],
                      markersize=3, label="$V_p^*$, can be held")
    voltages.set_ylabel("$V^*$")
    voltages.legend(frameon=False, loc="upper center")
    # 1e-8 is what the search for the limit resolves.
    ratio.loglog(rates, np.maximum(failure / hold - 1, 1e-9), "o-",
                 color=GREY, markersize=3)
    ratio.axhspan(ratio.get_ylim()[0], 1e-7, color="#eeeeee", linewidth=0)
    ratio.text(rates[-1], 2e-8, "not resolved", ha="right", size=7, color=GREY)
    ratio.set_ylabel("$V_f^* / V_p^* - 1$")
    for panel in (voltages, ratio):
        panel.set_xlabel(r"rate $r$ of $V^*$ (1/s)")
    paper.number_panels((voltages, ratio))
    return figure


def draw_ranges(study):
    rates, highest = study.get_curve("rate", "frequency at hold limit")
    at_rest = study.cases[0]["frequency without voltage"]
    lowest = study.get_curve("rate", "lowest frequency")[1]
    figure, (range_, path) = plt.subplots(
        1, 2, figsize=(paper.DOUBLE, 2.5), layout="constrained",
        width_ratios=(1, 1))
    top = (highest - at_rest) / paper.FREQUENCY
    bottom = (lowest - at_rest) / paper.FREQUENCY
    range_.fill_between(rates, bottom, top, color=COLOURS[5], alpha=0.35,
                        linewidth=0)
    range_.semilogx(rates, top, "o-", color=COLOURS[0], markersize=3,
                    label=r"largest, at $V_p^*$")
    range_.semilogx(rates, bottom, "s-", color=COLOURS[1], markersize=3,
                    label="smallest")
    range_.set_xlabel(r"rate $r$ of $V^*$ (1/s)")
    range_.legend(frameon=False, loc="center right")
    history = study.read_history(study.cases[0])
    path.plot(history["voltage"] / paper.VOLTAGE,
              (history["natural frequency"] - at_rest) / paper.FREQUENCY,
              color=GREY, label="relaxed")
    holds = study.get_curve("rate", "hold limit")[1] / paper.VOLTAGE
    path.axvspan(holds.min(), holds.max(), color=COLOURS[0], alpha=0.25,
                 linewidth=0, label=r"$V_p^*$ of all rates")
    path.set_xlabel("$V^*$")
    path.legend(frameon=False, loc="upper left")
    for panel in (range_, path):
        panel.set_ylabel(r"$\Delta\Omega$")
    paper.number_panels((range_, path))
    return figure


def main():
    study = paper.load(sys.argv)
    draw = draw_voltages if study.get_figure() == "3.13" else draw_ranges
    paper.save(draw(study), study)


if __name__ == "__main__":
    main()
