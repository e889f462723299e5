#!/usr/bin/env python3
"""Figure 14 of Wang et al. (2024): the half angle of the DEMES at rest over
temperature and pre-stretch, and the voltage that straightens its frame.

Usage: demes_rest.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import COLOURS, plt

LAWS = {"softening": "-", "entropic": "--", "constant": ":"}


def find_crossing(voltage, angle):
    """e where the angle of consecutive rest states becomes zero: theta^2 falls
    in proportion to V there, or the frame jumps. nan if it stays bent."""
    straight = np.flatnonzero(angle == 0)
    if not len(straight) or straight[0] < 2:
        return np.nan
    first = straight[0]
    squares = angle[first - 2:first]**2
    slope = (squares[1] - squares[0]) / (voltage[first - 1] -
                                         voltage[first - 2])
    found = voltage[first - 1] - squares[1] / slope
    between = sorted(voltage[first - 1:first + 1])
    return paper.FIELD * float(np.clip(found, *between))


def find_straight_fields(history):
    """e above which a rising voltage leaves the frame straight, and e below
    which a falling one lets it bend again."""
    voltage, angle = history["voltage"], history["angle"]
    top = np.argmax(voltage)
    return (find_crossing(voltage[:top + 1], angle[:top + 1]),
            find_crossing(voltage[:top:-1], angle[:top:-1]))


def main():
    study = paper.load(sys.argv)
    shades = paper.get_shades(study.get_values("pre_stretch"))
    temperatures = study.get_values("temperature")
    figure, (heated, bent, straight) = plt.subplots(
        1, 3, figsize=(paper.DOUBLE, 2.7), layout="constrained")
    for stretch, colour in shades.items():
        for law, style in LAWS.items():
            heated.plot(*study.get_curve("temperature", "rest angle", laws=law,
                                         pre_stretch=stretch),
                        style, color=colour, linewidth=0.9)
    for temperature, colour in zip(temperatures, COLOURS):
        bent.plot(*study.get_curve("pre_stretch", "rest angle",
                                   laws="softening", temperature=temperature),
                  ".-", color=colour, linewidth=0.9,
                  label=f"{temperature:g} K")
        cases = study.select(laws="softening", temperature=temperature)
        straight.plot([case["pre_stretch"] for case in cases],
                      [find_straight_fields(study.read_history(case))[1]
                       for case in cases], ".-", color=colour, linewidth=0.9)
    heated.set_xlabel("temperature (K)")
    heated.set_ylabel(r"$\theta$ at rest (rad)")
    for panel in (bent, straight):
        panel.set_xlabel(r"$\lambda_p$")
    bent.set_ylabel(r"$\theta$ at rest (rad)")
    bent.legend(frameon=False, loc="lower right")
    straight.set_ylabel("$e$ that straightens the frame")
    paper.number_panels((heated, bent, straight))
    paper.add_legend(
        figure,
        [paper.make_line(colour, rf"$\lambda_p = {stretch:g}$")
         for stretch, colour in shades.items()] +
        [paper.make_line("black", law + " laws", style)
         for law, style in LAWS.items()], columns=5)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
