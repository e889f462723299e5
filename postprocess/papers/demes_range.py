#!/usr/bin/env python3
"""Figure 8 of Wang et al. (2024): range and mean of the half angle after a direct
voltage is switched on, over the pre-stretch.

Usage: demes_range.py FOLDER
"""

import sys

import paper
from taut_plots import plt

STYLES = {0.03: "--", 0.3: "-"}
MARKERS = "osD^v"


def main():
    study = paper.load(sys.argv)
    fields = study.get_values("field")
    shades = paper.get_shades(fields)
    figure, (spread, mean) = plt.subplots(1, 2, figsize=(paper.DOUBLE, 2.7),
                                          layout="constrained")
    for number, style in STYLES.items():
        for field, marker in zip(fields, MARKERS):
            cases = study.select(field=field, relaxation=number)
            stretches = [case["pre_stretch"] for case in cases]
            look = {"color": shades[field], "linestyle": style,
                    "marker": marker, "markersize": 3, "linewidth": 0.9}
            spread.plot(stretches,
                        [case["largest angle"] - case["smallest angle"]
                         for case in cases], **look)
            mean.plot(stretches, [case["mean angle"] for case in cases], **look)
    spread.set_ylabel(r"$\theta_{\max} - \theta_{\min}$ (rad)")
    mean.set_ylabel(r"mean of $\theta$ (rad)")
    for panel in (spread, mean):
        panel.set_xlabel(r"$\lambda_p$")
    paper.number_panels((spread, mean))
    handles = [plt.Line2D([], [], color=shades[field], marker=marker,
                          markersize=3, label=f"$e = {field:g}$")
               for field, marker in zip(fields, MARKERS)]
    handles += [paper.make_line("black", f"$S = {number:g}$", style)
                for number, style in STYLES.items()]
    paper.add_legend(figure, handles)
    paper.save(figure, study)


if __name__ == "__main__":
    main()
