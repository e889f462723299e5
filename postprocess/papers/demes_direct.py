#!/usr/bin/env python3
"""Figures 7 and 15 of Wang et al. (2024): phase paths of the DEMES after a
direct voltage is switched on.

Usage: demes_direct.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import COLOURS, GREY, plt

SETS = {1: r"$S = 0.03,\ e = 0.30$", 2: r"$S = 0.3,\ e = 0.55$"}


def draw_path(panel, study, case, colour):
    """The path with its start; whether it is a faint one."""
    history = study.read_history(case)
    angle = history["angle"]
    velocity = history["angular velocity"] / paper.OMEGA
    faint = paper.swings_over(angle)
    panel.plot(angle, velocity, color=colour, linewidth=0.5,
               alpha=paper.FAINT if faint else 1)
    panel.plot(angle[0], velocity[0], "o", color=GREY, markersize=2.5)
    panel.locator_params(axis="x", nbins=4)
    panel.locator_params(axis="y", nbins=5)
    return faint


def draw_grid(study, rows, columns, height):
    """`rows` and `columns`: lists of (title, values of the variables)."""
    figure, axes = plt.subplots(len(rows), len(columns),
                                figsize=(paper.DOUBLE, height),
                                layout="constrained")
    titles, faint = [], False
    for index, (row_title, row, colour) in enumerate(rows):
        for panel, (column_title, column) in zip(axes[index], columns):
            faint |= draw_path(panel, study, study.get(**row, **column), colour)
            titles.append(", ".join(filter(None, (row_title, column_title))))
        axes[index][0].set_ylabel(r"$\theta' = \dot\theta/\omega_0$")
    for panel in axes[-1]:
        panel.set_xlabel(r"$\theta$ (rad)")
    paper.number_panels(axes.flat, titles)
    return figure, faint


def draw_sets(study):
    """Parameter sets below one another, pre-stretches side by side."""
    rows = [("", {"parameters": number}, colour)
            for number, colour in zip(SETS, COLOURS)]
    columns = [(rf"$\lambda_p = {stretch:g}$", {"pre_stretch": stretch})
               for stretch in study.get_values("pre_stretch")]
    figure, faint = draw_grid(study, rows, columns, 3.7)
    handles = [paper.make_line(colour, SETS[number])
               for number, colour in zip(SETS, COLOURS)]
    if faint:
        handles.append(paper.make_line(plt.matplotlib.colors.to_rgba(
            COLOURS[1], paper.FAINT), paper.FAINT_NOTE))
    paper.add_legend(figure, handles)
    return figure


def draw_temperatures(study):
    """Pre-stretches below one another, temperatures side by side; the first
    parameter set."""
    stretches = study.get_values("pre_stretch")
    shades = paper.get_shades(stretches)
    rows = [(rf"$\lambda_p = {stretch:g}$",
             {"pre_stretch": stretch, "parameters": 1}, shades[stretch])
            for stretch in stretches]
    columns = [(f"{temperature:g} K", {"temperature": temperature})
               for temperature in study.get_values("temperature")]
    figure = draw_grid(study, rows, columns, 6.4)[0]
    share_rows(figure, len(columns))
    return figure


def share_rows(figure, n_columns):
    """The same limits in all panels of a row."""
    for row in np.array(figure.axes).reshape(-1, n_columns):
        for get, put in (("get_xlim", "set_xlim"), ("get_ylim", "set_ylim")):
            limits = np.array([getattr(panel, get)() for panel in row])
            for panel in row:
                getattr(panel, put)(limits[:, 0].min(), limits[:, 1].max())


def main():
    study = paper.load(sys.argv)
    paper.save(draw_temperatures(study) if study.has("temperature")
               else draw_sets(study), study)


if __name__ == "__main__":
    main()
