#!/usr/bin/env python3
"""Figures 9 and 16 of Wang et al. (2024): amplitude of the half angle of the DEMES
under an alternating voltage over its frequency.

Usage: demes_response.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import GREY, plt

SETS = {1: "$S = 0.03$, $e = 0.30$", 2: "$S = 0.3$, $e = 0.55$",
        3: "$S = 0.03$, $e = 0.80$", 4: "$S = 1$, $e = 0.30$"}


def draw_curve(panel, response, colour):
    """Full where the motion is reproducible, faint where it depends on the last
    digits of its start."""
    omega = 2 * np.pi * response["frequency"] / paper.OMEGA
    amplitude = response["amplitude"]
    panel.plot(omega, amplitude, color=colour, linewidth=0.6,
               alpha=paper.FAINT)
    panel.plot(omega, np.where(response["reproducible"] > 0, amplitude, np.nan),
               color=colour, linewidth=0.9)


def list_panels(study):
    """(title, values of the variables) of every panel."""
    if not study.has("temperature"):
        return [(SETS[number], {"parameters": number})
                for number in study.get_values("parameters")]
    return [(f"{temperature:g} K, {law} laws",
             {"temperature": temperature, "laws": law})
            for law in study.get_values("laws")
            for temperature in study.get_values("temperature")]


def main():
    study = paper.load(sys.argv)
    shades = paper.get_shades(study.get_values("pre_stretch"))
    panels = list_panels(study)
    columns = 3 if study.has("temperature") else 2
    figure, axes = plt.subplots(len(panels) // columns, columns, sharex=True,
                                sharey="row" if columns == 3 else False,
                                figsize=(paper.DOUBLE, 4.2),
                                layout="constrained")
    for panel, (_, values) in zip(axes.flat, panels):
        for stretch, colour in shades.items():
            case = study.get(pre_stretch=stretch, **values)
            draw_curve(panel, study.read_history(case), colour)
    for panel in axes.flat:
        panel.set_ylim(bottom=0)
    for panel in axes[-1]:
        panel.set_xlabel(r"$\omega / \omega_0$")
        panel.set_xlim(0, 4)
    for panel in axes[:, 0]:
        panel.set_ylabel(r"amplitude of $\theta$ (rad)")
    paper.number_panels(axes.flat, [title for title, _ in panels])
    handles = [paper.make_line(colour, rf"$\lambda_p = {stretch:g}$")
               for stretch, colour in shades.items()]
    handles.append(paper.make_line(
        plt.matplotlib.colors.to_rgba(GREY, paper.FAINT),
        "faint: not reproducible to the eye"))
    paper.add_legend(figure, handles)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
