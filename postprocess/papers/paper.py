"""What the plots and the claims of the papers share: the folders that `taut
study` leaves, the units of both papers, and the style of their figures."""

import csv
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import numpy as np  # noqa: E402
import taut_plots as plots  # noqa: E402
from taut_plots import plt  # noqa: E402

# omega = 1 of prm/papers/demes.prm (rad/s): tau = OMEGA t.
OMEGA = 2 * np.pi * 5
# e = FIELD V of the same device, which has 0.3 at 5 kV (1/V).
FIELD = 0.3 / 5000
# V* = 1 (V) and Omega = 1 (Hz) of prm/papers/resonator.prm with k = 1.
VOLTAGE = 31003.21284
FREQUENCY = 7.072544

# Widths of one and of two columns of a journal (inch).
SINGLE, DOUBLE = 3.5, 7.2


def get_frequency(ratio):
    """Omega = 1 (Hz) of that resonator for another k: its passive strip is 1 / k
    times as long."""
    strip = 960 * 0.02**2 / (3 * 40e3)
    bar = 0.02 / (40e3 * 1e-3)
    alpha = 1 / (strip + strip / ratio + bar)
    return np.sqrt(alpha) / (2 * np.pi)


def read_number(text):
    try:
        return float(text)
    except ValueError:
        return text or np.nan


def is_same(one, other):
    """Whether two values are, to what a CSV keeps of them."""
    if isinstance(one, str) or isinstance(other, str):
        return one == other
    return bool(np.isclose(one, other, rtol=1e-9))


class Study:
    """A folder that `taut study` wrote."""

    def __init__(self, folder):
        self.folder = Path(folder)
        with open(self.folder / "study.csv", newline="",
                  encoding="utf-8") as stream:
            table = list(csv.reader(stream))
        names = [re.sub(r" \[.*\]$", "", title) for title in table[0]]
        self.cases = [dict(zip(names, map(read_number, row)))
                      for row in table[1:]]

    def get_values(self, name):
        """The values of a variable, without repetition, in their order."""
        return list(dict.fromkeys(case[name] for case in self.cases))

    def has(self, name):
        return name in self.cases[0]

    def select(self, **values):
        """The cases with these values of the variables."""
        return [case for case in self.cases
                if all(is_same(case[name], value)
                       for name, value in values.items())]

    def get(self, **values):
        """The one case with these values."""
        found = self.select(**values)
        if len(found) != 1:
            raise SystemExit(f"{self.folder}: {len(found)} cases with {values}")
        return found[0]

    def get_curve(self, x, y, **values):
        """Two results of the cases with these values, as arrays."""
        found = self.select(**values)
        return (np.array([case[x] for case in found], float),
                np.array([case[y] for case in found], float))

    def read_history(self, case):
        """history.csv of a case: {name: array}."""
        folder = self.folder / case["folder"]
        if not folder.exists():
            folder = self.folder / "cases" / case["folder"]
        file = folder / "history.csv"
        with open(file, encoding="utf-8") as stream:
            names = [re.sub(r" \[.*\]$", "", title)
                     for title in next(csv.reader(stream))]
        rows = np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)
        return dict(zip(names, rows.T))

    def find_sibling(self):
        """The lumped study of the same figure beside this folder, or None:
        demes_04 beside demes_04_film."""
        folder = self.folder.resolve()
        other = folder.with_name(folder.name.removesuffix("_film"))
        return (Study(other) if other != folder and
                (other / "study.csv").exists() else None)

    def get_figure(self):
        """The number of the figure in the study's title."""
        text = (self.folder / "parameters.prm").read_text(encoding="utf-8")
        found = re.search(r"Title *=.*figure ([\d.]+)", text)
        if not found:
            raise SystemExit(f"{self.folder}: the title of the study names no "
                             "figure")
        return found[1].rstrip(".")


def load(arguments):
    """The study whose folder is the only argument of a script."""
    if len(arguments) != 2:
        raise SystemExit(f"usage: {Path(arguments[0]).name} FOLDER")
    plots.set_style()
    return Study(arguments[1])


def save(figure, study):
    """Writes figure.png, .svg and .pdf into the folder of the study."""
    plots.save(figure, study.folder / "figure", ("png", "svg", "pdf"))


def get_shade(value, lowest, highest):
    """A colour of viridis, without its pale end."""
    share = (value - lowest) / (highest - lowest) if highest > lowest else 0
    return plt.get_cmap("viridis")(0.88 * share)


def get_shades(values):
    """{value: colour} over the range of the values."""
    return {value: get_shade(value, min(values), max(values))
            for value in values}


def number_panels(axes, titles=None, letters="abcdefghijklmnopqrstuvwxyz"):
    """Bold letters, and titles behind them, above the left ends of panels."""
    for index, panel in enumerate(axes):
        title = titles[index] if titles else ""
        panel.set_title(rf"$\bf{{{letters[index]}}}$  {title}", loc="left")


def add_legend(figure, handles, title=None, columns=None):
    """Above all panels."""
    figure.legend(handles=handles, title=title, frameon=False,
                  ncol=columns or len(handles), loc="lower center",
                  bbox_to_anchor=(0.5, 1.0), columnspacing=1.4,
                  handlelength=1.6)


def make_line(colour, label, style="-", width=1.2):
    return plt.Line2D([], [], color=colour, linestyle=style, linewidth=width,
                      label=label)


def show_stretches(figure, shades):
    """A legend of pre-stretches."""
    add_legend(figure, [make_line(colour, rf"$\lambda_p = {value:g}$")
                        for value, colour in shades.items()])


def swings_over(angle):
    """Whether a motion passes the straight frame, where neighbours separate so
    fast that the path is one of many: it is then drawn faint."""
    return np.min(angle) < 0 < np.max(angle)


FAINT = 0.35
FAINT_NOTE = ("faint: passes the straight frame, a path not reproducible "
              "to the eye")
