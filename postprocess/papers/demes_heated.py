#!/usr/bin/env python3
"""Figures 11, 12 and 13 of Wang et al. (2024): the DEMES after release from the
straight frame at three temperatures.

Usage: demes_heated.py FOLDER
"""

import sys

import paper
from taut_plots import plt

QUANTITIES = {"11": ("angle", r"$\theta$ (rad)", 1),
              "12": ("angular velocity", r"$\theta' = \dot\theta/\omega_0$",
                     1 / paper.OMEGA),
              "13": ("inner stretch", r"$\xi$", 1)}
SHOWN = 100  # tau


def draw_case(panel, study, case, quantity, colour):
    name, label, factor = quantity
    history = study.read_history(case)
    tau = paper.OMEGA * history["time"]
    shown = tau <= SHOWN
    panel.plot(tau[shown], factor * history[name][shown], color=colour,
               linewidth=0.7)


def draw(study, quantity):
    """Temperatures side by side, pre-stretches below one another."""
    temperatures = study.get_values("temperature")
    shades = paper.get_shades(study.get_values("pre_stretch"))
    figure, axes = plt.subplots(len(shades), len(temperatures), sharex=True,
                                sharey="row", figsize=(paper.DOUBLE, 5.2),
                                layout="constrained")
    titles = []
    for row, (stretch, colour) in zip(axes, shades.items()):
        for panel, temperature in zip(row, temperatures):
            draw_case(panel, study,
                      study.get(pre_stretch=stretch, temperature=temperature),
                      quantity, colour)
            titles.append(rf"$\lambda_p = {stretch:g}$, {temperature:g} K")
        row[0].set_ylabel(quantity[1])
    for panel in axes[-1]:
        panel.set_xlabel(r"$\tau = \omega_0 t$")
        panel.set_xlim(0, SHOWN)
    paper.number_panels(axes.flat, titles)
    return figure


def main():
    study = paper.load(sys.argv)
    paper.save(draw(study, QUANTITIES[study.get_figure()]), study)


if __name__ == "__main__":
    main()
