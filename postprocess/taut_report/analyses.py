"""Comparison, modes, motion and frequency response."""

import math

import taut_numbers as numbers

from . import markup
from .charts import Axis, Chart, Series, find_finite, make_gallery
from .histories import find_column
from .markup import section, tag
from .tables import count_rows

# Rows that are shown at once.
FEW = 20
MODELS = ("film", "lumped", "finite elements", "elastica", "arc")


def split_model(name):
    """("stretch", "film") of a column of compare.csv."""
    for model in MODELS:
        if name.endswith(" " + model):
            return name.removesuffix(" " + model), model
    return name, None


def make_comparison_charts(columns):
    quantities = {}
    for column in columns[1:]:
        quantity, model = split_model(column.name)
        quantities.setdefault(quantity, []).append((model, column))
    axis = Axis("time", "s", columns[0].values)
    return [Chart(name, axis, pairs[0][1].unit,
                  [Series(model or name, column.values)
                   for model, column in pairs])
            for name, pairs in quantities.items()]


def make_differences(comparison):
    rows = []
    for entry in comparison.get("quantities") or []:
        rows.append([entry.get("name", ""),
                     markup.number(entry.get("max_relative_difference"), 3),
                     markup.number(entry.get("rms_relative_difference"), 3),
                     markup.quantity(entry.get("time_of_max"), "s")])
    if not rows:
        return None
    return markup.table(
        "Differences relative to the largest lumped value of the run",
        ["Quantity", "Largest", "Root mean square", "Time of the largest"],
        rows, "tnnn")


def make_comparison(results):
    if not results.comparison and not results.tables["compare"]:
        return None
    columns = results.tables["compare"]
    charts = make_comparison_charts(columns) if columns else []
    return section("comparison", "Finite elements against lumped models",
                   make_differences(results.comparison),
                   make_models(results.comparison.get("models")),
                   make_gallery(charts) if charts else None,
                   describe_values(results.comparison, "All of compare.json",
                                   {"quantities", "models"}))


def flatten(value, path=()):
    """(path, leaf) of nested objects; lists of numbers stay together."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from flatten(inner, path + (str(key).replace("_", " "),))
    elif isinstance(value, list) and any(isinstance(v, (dict, list))
                                         for v in value):
        for place, inner in enumerate(value, start=1):
            yield from flatten(inner, path + (str(place),))
    else:
        yield path, value


def show_value(value):
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, (int, float)):
        return markup.number(value)
    if isinstance(value, list):
        return [[", " if place else "", show_value(item)]
                for place, item in enumerate(value)]
    return "–" if value is None else str(value)


def describe_values(content, title, but=()):
    """Whatever an object of a JSON file holds; to be unfolded if it is long."""
    if not isinstance(content, dict):
        return None
    rows = [[" › ".join(path), show_value(value)] for path, value in flatten(
        {k: v for k, v in content.items() if k not in but})]
    if not rows:
        return None
    return tag("details", tag("summary", title), markup.table(
        f"{title}, in SI units", ["What", "Value"], rows),
               open=len(rows) <= FEW)


def make_models(models):
    """One column a model, one row a finding."""
    if not models or not all(isinstance(m, dict) for m in models):
        return None
    names = [model.get("name", "") for model in models]
    findings = [dict(flatten({k: v for k, v in model.items()
                              if k != "name" and v is not None}))
                for model in models]
    paths = list(dict.fromkeys(path for found in findings for path in found))
    rows = [[" › ".join(path)] + [show_value(found.get(path))
                                  for found in findings] for path in paths]
    return markup.table("Findings of each model, in SI units",
                        ["Finding"] + names, rows, "t" + "n" * len(names))


def make_cell(column, row):
    value = column.values[row]
    if not column.is_number:
        return value
    if math.isnan(value):
        return "–"
    return markup.number(value)


# Longer texts are wrapped.
SHORT = 48


def choose_kind(column):
    if column.is_number:
        return "n"
    return "w" if all(len(text) <= SHORT for text in column.values) else "t"


def show_columns(caption, columns):
    head = [numbers.make_label(c.name, c.unit) for c in columns]
    rows = [[make_cell(c, row) for c in columns]
            for row in range(count_rows(columns))]
    return markup.table(caption, head, rows,
                        "".join(map(choose_kind, columns)))


def make_modes(results):
    columns = results.tables["modes"]
    if not columns:
        return None
    found = results.summary.get("modes") or {}
    stable = found.get("stable")
    words = None
    if stable is not None:
        words = tag("p", "The state is ", tag("strong", "stable" if stable
                                              else "not stable"), ".")
    return section("modes", "Modes", words, show_columns(
        "Modes of vibration about the state", columns))


def make_scatter(title, x, y):
    return Chart(title, Axis(x.name, x.unit, x.values), y.unit,
                 [Series(y.name, y.values, marks=True, line=False)])


def make_section_charts(columns):
    """Each quantity over the first that is not time or a count."""
    counts = {"time", "period", "passage", "point", "index"}
    wanted = [c for c in columns if c.is_number and not c.is_empty()
              and c.name not in counts]
    if len(wanted) < 2:
        return [make_scatter(c.name, columns[0], c) for c in wanted]
    return [make_scatter(f"{c.name} over {wanted[0].name}", wanted[0], c)
            for c in wanted[1:]]


def make_spectrum_charts(columns):
    x = columns[0]
    return [Chart(f"spectrum of {c.name}" if c.name != "amplitude"
                  else "spectrum", Axis(x.name, x.unit, x.values), c.unit,
                  [Series(c.name, c.values)])
            for c in columns[1:] if c.is_number and any(find_finite(c.values))]


def make_motion(results):
    motion = results.summary.get("motion")
    section_table = results.tables["section"]
    spectrum = results.tables["spectrum"]
    charts = make_section_charts(section_table) if section_table else []
    charts += make_spectrum_charts(spectrum) if spectrum else []
    if not motion and not charts:
        return None
    words = None
    if isinstance(motion, dict) and motion.get("class"):
        words = tag("p", "The motion is ", tag("strong", motion["class"]), ".")
    return section("motion", "Motion", words,
                   make_gallery(charts) if charts else None,
                   describe_values(motion, "All about the motion")
                   if motion else None)


# Of the points of a response: no results.
OF_A_POINT = {"direction", "settled", "periods", "period number",
              "reproducible"}


def split_directions(columns):
    """Upward and downward sweeps with nan where the other one is."""
    direction = find_column(columns, "direction")
    if direction is None:
        return [("", [True] * count_rows(columns))]
    return [(name, [value * sign > 0 for value in direction.values])
            for name, sign in (("up", 1), ("down", -1))]


def make_response(results):
    columns = results.tables["response"]
    if not columns:
        return None
    x = columns[0]
    ways = split_directions(columns)
    charts = []
    for c in columns[1:]:
        if c.name in OF_A_POINT or not c.is_number or c.is_empty():
            continue
        charts.append(Chart(
            c.name, Axis(x.name, x.unit, x.values), c.unit,
            [Series(name or c.name,
                    [v if here else math.nan
                     for v, here in zip(c.values, which)], marks=True)
             for name, which in ways if any(which)]))
    return section("response", "Frequency response", make_gallery(charts))
