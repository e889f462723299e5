#!/usr/bin/env python3
"""Figures 4, 7, 9 and 14 of Wang et al. (2024) by finite elements, with the model
of one angle (dashed) beside them if its study stands beside this one.

Usage: demes_film.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import COLOURS, GREY, plt

MODELS = [paper.make_line("black", "finite elements"),
          paper.make_line("black", "model of one angle", "--")]


def get_velocity(history):
    """theta', by differences of the rows."""
    return np.gradient(history["angle"], history["time"]) / paper.OMEGA


def draw_release(study, lumped):
    """Figure 4: a panel for each pre-stretch, rest angles as marks."""
    shades = paper.get_shades(study.get_values("pre_stretch"))
    figure, panel = plt.subplots(figsize=(paper.DOUBLE, 2.8),
                                 layout="constrained")
    for stretch, colour in shades.items():
        history = study.read_history(study.get(pre_stretch=stretch))
        panel.plot(paper.OMEGA * history["time"], history["angle"],
                   color=colour, linewidth=0.9)
        if lumped:
            case = lumped.get(pre_stretch=stretch, relaxation=0.3)
            panel.plot([0.92, 1], [case["final angle"]] * 2, "--", color=colour,
                       transform=panel.get_yaxis_transform())
    panel.set_xlabel(r"$\tau = \omega_0 t$")
    panel.set_ylabel(r"$\theta$ (rad)")
    panel.set_xlim(0, 50)
    handles = [paper.make_line(colour, rf"$\lambda_p = {stretch:g}$")
               for stretch, colour in shades.items()]
    handles.append(paper.make_line("black", "rest of the model of one angle",
                                   "--"))
    paper.add_legend(figure, handles)
    return figure


def draw_paths(study, lumped):
    """Figure 7: phase paths from the rest without voltage, which differs."""
    stretches = study.get_values("pre_stretch")
    figure, axes = plt.subplots(1, len(stretches), figsize=(paper.DOUBLE, 2.1),
                                layout="constrained")
    for panel, stretch in zip(axes, stretches):
        history = study.read_history(study.get(pre_stretch=stretch))
        if lumped:
            case = lumped.get(pre_stretch=stretch, parameters=1)
            path = lumped.read_history(case)
            shown = path["time"] <= history["time"][-1]
            panel.plot(path["angle"][shown] - path["angle"][0],
                       path["angular velocity"][shown] / paper.OMEGA,
                       color=GREY, linewidth=0.4)
        angle = history["angle"] - history["angle"][0]
        panel.plot(angle, get_velocity(history), color=COLOURS[0],
                   linewidth=0.5)
        panel.locator_params(nbins=4)
        panel.set_xlabel(r"$\theta - \theta(0)$ (rad)")
    axes[0].set_ylabel(r"$\theta' = \dot\theta/\omega_0$")
    paper.number_panels(axes, [rf"$\lambda_p = {stretch:g}$"
                               for stretch in stretches])
    paper.add_legend(figure,
                     [paper.make_line(COLOURS[0], "finite elements"),
                      paper.make_line(GREY, "model of one angle")])
    return figure


def draw_response(study, lumped):
    """Figure 9: a few frequencies upon the lumped curve."""
    figure, panel = plt.subplots(figsize=(paper.SINGLE, 2.6),
                                 layout="constrained")
    if lumped:
        curve = lumped.read_history(lumped.get(pre_stretch=3, parameters=1))
        panel.plot(2 * np.pi * curve["frequency"] / paper.OMEGA,
                   curve["amplitude"], color=GREY, linewidth=0.9)
    panel.plot(*study.get_curve("omega", "amplitude"), "o:", color=COLOURS[0],
               markersize=3, linewidth=0.7)
    panel.set_xlim(0, 4)
    panel.set_ylim(bottom=0)
    panel.set_xlabel(r"$\omega / \omega_0$")
    panel.set_ylabel(r"amplitude of $\theta$ (rad), $\lambda_p = 3$")
    paper.add_legend(figure,
                     [plt.Line2D([], [], color=COLOURS[0], marker="o",
                                 linestyle=":", markersize=3,
                                 label="finite elements"),
                      paper.make_line(GREY, "model of one angle")])
    return figure


def draw_rests(study, lumped):
    """Figure 14: rest angle over the temperature."""
    shades = paper.get_shades(study.get_values("pre_stretch"))
    figure, panel = plt.subplots(figsize=(paper.SINGLE, 2.8),
                                 layout="constrained")
    for stretch, colour in shades.items():
        history = study.read_history(study.get(pre_stretch=stretch))
        panel.plot(history["temperature"], history["angle"], color=colour)
        if lumped:
            panel.plot(*lumped.get_curve("temperature", "rest angle",
                                         pre_stretch=stretch,
                                         laws="softening"), "--",
                       color=colour)
    panel.set_xlabel("temperature (K)")
    panel.set_ylabel(r"$\theta$ at rest (rad)")
    paper.add_legend(figure,
                     [paper.make_line(colour, rf"$\lambda_p = {stretch:g}$")
                      for stretch, colour in shades.items()] + MODELS,
                     columns=2)
    return figure


DRAWINGS = {"4": draw_release, "7": draw_paths, "9": draw_response,
            "14": draw_rests}


def main():
    study = paper.load(sys.argv)
    draw = DRAWINGS[study.get_figure()]
    paper.save(draw(study, study.find_sibling()), study)


if __name__ == "__main__":
    main()
