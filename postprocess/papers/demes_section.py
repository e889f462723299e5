#!/usr/bin/env python3
"""Figures 10 and 17 of Wang et al. (2024): phase paths of the DEMES under an
alternating voltage, and their points once a period.

Usage: demes_section.py FOLDER
"""

import sys

import paper
from demes_direct import SETS
from taut_plots import COLOURS, GREY, plt

STROBE = 80  # rows in a period of the drive
SHADES = ["#e0a15a", "#D55E00", "#000000"]


def list_parts(n_periods):
    """First and last period of early, middle and late points."""
    if n_periods == 100:
        return [(1, 30), (31, 60), (61, 100)]
    third = n_periods // 3
    return [(1, third), (third + 1, 2 * third), (2 * third + 1, n_periods)]


def get_path(history):
    return history["angle"], history["angular velocity"] / paper.OMEGA


def draw_case(panel, history):
    """The path of the last 40 periods, and all points of the section."""
    angle, velocity = get_path(history)
    faint = paper.swings_over(angle)
    parts = list_parts((len(angle) - 1) // STROBE)
    panel.plot(angle[-40 * STROBE:], velocity[-40 * STROBE:], color=COLOURS[5],
               linewidth=0.5, alpha=paper.FAINT if faint else 0.9, zorder=1)
    for colour, (first, last) in zip(SHADES, parts):
        points = slice(first * STROBE, last * STROBE + 1, STROBE)
        panel.plot(angle[points], velocity[points], ".", color=colour,
                   markersize=3.5, markeredgewidth=0,
                   zorder=2 + first / 1000)
    panel.locator_params(nbins=4)
    return faint, parts


def list_rows(study):
    """(title, values) of the rows of panels."""
    if study.has("temperature"):
        return [(f"{temperature:g} K", {"temperature": temperature})
                for temperature in study.get_values("temperature")]
    return [(SETS[number], {"parameters": number})
            for number in study.get_values("parameters")]


def main():
    study = paper.load(sys.argv)
    rows = list_rows(study)
    stretches = study.get_values("pre_stretch")
    figure, axes = plt.subplots(len(rows), len(stretches),
                                figsize=(paper.DOUBLE, 0.2 + 1.8 * len(rows)),
                                layout="constrained")
    titles, faint = [], False
    for line, (title, values) in zip(axes, rows):
        for panel, stretch in zip(line, stretches):
            case = study.get(pre_stretch=stretch, **values)
            passes, parts = draw_case(panel, study.read_history(case))
            faint |= passes
            titles.append(rf"$\lambda_p = {stretch:g}$" +
                          (f", {title}" if "K" in title else ""))
        line[0].set_ylabel(("" if "K" in title else title + "\n") +
                           r"$\theta' = \dot\theta/\omega_0$")
    for panel in axes[-1]:
        panel.set_xlabel(r"$\theta$ (rad)")
    paper.number_panels(axes.flat, titles)
    handles = [plt.Line2D([], [], color=colour, marker=".", linestyle="",
                          label=f"periods {first} to {last}")
               for colour, (first, last) in zip(SHADES, parts)]
    handles.append(paper.make_line(COLOURS[5], "path of the last 40"))
    if faint:
        handles.append(paper.make_line(
            plt.matplotlib.colors.to_rgba(COLOURS[5], paper.FAINT),
            "passes the straight frame,\nnot reproducible to the eye"))
    paper.add_legend(figure, handles)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
