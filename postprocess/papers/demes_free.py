#!/usr/bin/env python3
"""Figures 4, 5 and 6 of Wang et al. (2024): the DEMES after release from the
straight frame.

Usage: demes_free.py FOLDER
"""

import sys

import numpy as np
import paper
from taut_plots import GREY, plt

SHOWN = 100  # tau


def select_first_seed(study, number):
    """The cases of one S, of several seed angles those with the first."""
    if not study.has("seed"):
        return study.select(relaxation=number)
    return study.select(relaxation=number, seed=study.get_values("seed")[0])


def draw_histories(study, quantity, label, rests):
    """A panel for every S, with the rest values as ticks at the right."""
    numbers = study.get_values("relaxation")
    shades = paper.get_shades(study.get_values("pre_stretch"))
    figure, axes = plt.subplots(len(numbers), 1, sharex=True,
                                figsize=(paper.DOUBLE, 1.75 * len(numbers)),
                                layout="constrained")
    for panel, number in zip(axes, numbers):
        for case in select_first_seed(study, number):
            history = study.read_history(case)
            tau = paper.OMEGA * history["time"]
            shown = tau <= SHOWN
            colour = shades[case["pre_stretch"]]
            panel.plot(tau[shown], history[quantity][shown], color=colour,
                       linewidth=0.9)
            panel.plot([1.005, 1.02], [rests[case["pre_stretch"]]] * 2,
                       color=colour, clip_on=False,
                       transform=panel.get_yaxis_transform())
        panel.set_ylabel(label)
        panel.set_xlim(0, SHOWN)
    axes[-1].set_xlabel(r"$\tau = \omega_0 t$")
    paper.number_panels(axes, [f"$S = {number:g}$" for number in numbers])
    paper.show_stretches(figure, shades)
    return figure


def get_rests(study, name):
    """The value at the end of the longest run that has settled best."""
    last = {}
    for case in study.cases:
        value = case[name]
        known = last.setdefault(case["pre_stretch"], [])
        known.append((case["relaxation"], value))
    # S = 0.3 and 1 die out fastest.
    return {stretch: min(known, key=lambda pair: abs(np.log(pair[0] / 0.5)))[1]
            for stretch, known in last.items()}


def draw_paths(study):
    """A panel for every pre-stretch, and the peaks over it."""
    stretches = study.get_values("pre_stretch")
    shades = paper.get_shades(stretches)
    figure, axes = plt.subplots(2, 4, figsize=(paper.DOUBLE, 3.7),
                                layout="constrained")
    for panel, case in zip(axes.flat, study.cases):
        history = study.read_history(case)
        panel.plot(history["angle"], history["angular velocity"] / paper.OMEGA,
                   color=shades[case["pre_stretch"]], linewidth=0.6,
                   alpha=paper.FAINT if paper.swings_over(history["angle"])
                   else 1)
    last = axes.flat[-1]
    peaks = [case["largest angular velocity"] / paper.OMEGA
             for case in study.cases]
    last.plot(stretches, peaks, color=GREY, linewidth=0.8, zorder=1)
    last.scatter(stretches, peaks, s=14, color=list(shades.values()), zorder=2)
    last.set_xlabel(r"$\lambda_p$")
    last.set_ylabel(r"largest $\theta'$")
    for panel in axes.flat[:-1]:
        panel.set_xlabel(r"$\theta$ (rad)")
    for panel in axes[:, 0]:
        panel.set_ylabel(r"$\theta' = \dot\theta/\omega_0$")
    paper.number_panels(axes.flat, [rf"$\lambda_p = {stretch:g}$"
                                    for stretch in stretches] + [""])
    return figure


def main():
    study = paper.load(sys.argv)
    number = study.get_figure()
    if number == "4":
        figure = draw_histories(study, "angle", r"$\theta$ (rad)",
                                get_rests(study, "final angle"))
    elif number == "5":
        figure = draw_paths(study)
    else:
        figure = draw_histories(study, "inner stretch", r"$\xi$",
                                get_rests(study, "final inner stretch"))
    paper.save(figure, study)


if __name__ == "__main__":
    main()
