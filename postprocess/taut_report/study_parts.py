"""The table, the failures and the plots of a study."""

import math
from collections import Counter

import taut_numbers as numbers

from . import markup
from .analyses import show_columns
from .charts import Axis, Chart, Series, find_finite, make_gallery
from .markup import section, tag
from .pictures import make_plots
from .tables import Column, count_rows, find_column

# Between the variables and after the results.
OWN_COLUMNS = {"case", "time reached", "seconds", "status", "reason", "folder"}
MOST_CURVES, MOST_ROWS, MOST_BAD, MOST_OPEN_ROWS = 7, 500, 50, 40
BAD = ("failed", "refused", "interrupted")
SPREAD = 50.0


def list_variables(results):
    """Names of the varied variables: as study.json tells, or the columns that
    follow `case` until the first that study.json calls a result."""
    named = results.study.get("variables")
    if isinstance(named, dict):
        return list(named)
    if isinstance(named, list):
        return [v.get("name") if isinstance(v, dict) else v for v in named]
    columns = [c.name for c in results.tables["study"]
               if c.name not in OWN_COLUMNS]
    return columns[:1]


def list_results(results):
    variables = set(list_variables(results))
    return [c for c in results.tables["study"] if c.is_number
            and c.name not in OWN_COLUMNS | variables and not c.is_empty()]


def count_statuses(results):
    status = find_column(results.tables["study"], "status")
    return Counter(status.values) if status else Counter()


def choose_headline(results, counts):
    """Class of the banner and its headline."""
    bad = sum(counts[word] for word in BAD)
    ran = sum(counts.values())
    total = (results.study.get("cases") or {}).get("total", ran)
    if bad:
        return "failed", f"✕ {bad} of {total} cases did not succeed"
    if ran < total or not results.study or not ran:
        return "interrupted", f"❚❚ Not finished: {ran} of {total} cases done"
    if results.study.get("status") == "interrupted":
        return "interrupted", "❚❚ Interrupted"
    return "completed", f"✓ All {total} cases done"


def make_banner(results):
    counts = count_statuses(results)
    kind, headline = choose_headline(results, counts)
    lines = [tag("p", headline, class_="word")]
    if counts:
        said = ", ".join(f"{count} {word or 'without status'}"
                         for word, count in counts.most_common())
        lines.append(tag("p", said + "."))
    if kind == "interrupted":
        lines.append(tag("p", "The same command goes on where it was."))
    return tag("div", lines, class_=f"status {kind}", role="status")


def describe_variable(variable):
    values = variable.get("values") or []
    shown = ", ".join(map(str, values[:8])) + (", …" if len(values) > 8 else "")
    return [variable.get("name", ""), variable.get("key", ""), len(values),
            shown, numbers.write_unit(variable.get("unit", ""))]


def make_overview(results):
    """What was varied and how long it took."""
    study = results.study
    words = None
    if study.get("case_file"):
        words = tag("p", f"{study.get('command', 'run')} of ",
                    tag("code", study["case_file"]))
    pairs = [("cases", (study.get("cases") or {}).get("total")),
             ("wall time", markup.quantity(study["seconds"], "s", 3)
              if "seconds" in study else None)]
    variables = [v for v in study.get("variables") or []
                 if isinstance(v, dict)]
    table = markup.table("What was varied",
                         ["Variable", "Key", "Count", "Values", "Unit"],
                         [describe_variable(v) for v in variables],
                         "ttntt", stacks=True) if variables else None
    facts = [(name, value) for name, value in pairs if value]
    return section("overview", "Overview", words,
                   markup.facts(facts) if facts else None, table)


def describe_case(results, row):
    """"pre_stretch = 2, voltage = 5000"."""
    words = []
    for name in list_variables(results):
        column = find_column(results.tables["study"], name)
        if column:
            value = column.values[row]
            text = (numbers.format_quantity(value, column.unit)
                    if column.is_number else value)
            words.append(f"{name} = {text}")
    return ", ".join(words)


def make_failures(results):
    table = results.tables["study"]
    status, reason = (find_column(table, name)
                      for name in ("status", "reason"))
    folder = find_column(table, "folder")
    if status is None:
        return None
    bad = [row for row, word in enumerate(status.values) if word in BAD]
    rows = [[describe_case(results, row), status.values[row],
             reason.values[row] if reason else "",
             str(folder.values[row]) if folder else ""]
            for row in bad[:MOST_BAD]]
    if not rows:
        return None
    caption = "Cases that did not succeed, and why"
    if len(bad) > MOST_BAD:
        caption += f"; the first {MOST_BAD} of {len(bad)}"
    return section("failures", "Failed cases", markup.table(
        caption, ["Case", "Status", "Reason", "Folder"], rows, stacks=True))


def make_places(column):
    """Numbers as they are; words one after the other."""
    if column.is_number:
        return column.values
    order = list(dict.fromkeys(column.values))
    return [float(order.index(value)) for value in column.values]


def spans_decades(values):
    finite = find_finite(values)
    return bool(finite) and min(finite) > 0 and (
        max(finite) / min(finite) > SPREAD)


def group_rows(table, names):
    """Rows by the values of the other variables."""
    columns = [find_column(table, name) for name in names]
    groups = {}
    for row in range(count_rows(table)):
        key = tuple(column.values[row] for column in columns if column)
        groups.setdefault(key, []).append(row)
    return groups


def name_curve(names, key, table):
    words = []
    for name, value in zip(names, key):
        unit = find_column(table, name).unit
        text = (numbers.format_quantity(value, unit)
                if isinstance(value, float) else value)
        words.append(f"{name} = {text}")
    return ", ".join(words)


def make_chart(table, abscissa, others, result):
    places = make_places(abscissa)
    groups = group_rows(table, others)
    # Too many curves cannot be told apart: points only.
    if len(groups) > MOST_CURVES:
        series = [Series(result.name, result.values, marks=True, line=False)]
        x = places
    else:
        order = sorted(range(len(places)), key=lambda row: places[row])
        x = [places[row] for row in order]
        series = []
        for key, rows in groups.items():
            own = [row for row in order if row in set(rows)]
            series.append((name_curve(others, key, table), own))
        return make_curves(places, abscissa, result, series)
    return Chart(result.name, Axis(abscissa.name, abscissa.unit, x,
                                   spans_decades(x)), result.unit, series)


def make_curves(places, abscissa, result, series):
    """Curves of their own rows, one behind the other with gaps between them."""
    x, curves = [], []
    total = sum(len(rows) for _, rows in series)
    start = 0
    for name, rows in series:
        values = [math.nan] * total
        for place, row in enumerate(rows, start=start):
            values[place] = result.values[row]
            x.append(places[row])
        start += len(rows)
        curves.append(Series(name or result.name, values,
                             marks=len(rows) <= 60))
    return Chart(result.name, Axis(abscissa.name, abscissa.unit, x,
                                   spans_decades(x)), result.unit, curves)


def choose_abscissae(table, variables):
    """The variable of most values, the others being curves; every variable if
    the curves would be too many."""
    longest = max(variables, key=lambda v: len(set(map(str, v.values))))
    others = [v.name for v in variables if v is not longest]
    if len(group_rows(table, others)) <= MOST_CURVES:
        return [longest]
    return variables


def make_results(results):
    table = results.tables["study"]
    variables = [find_column(table, name) for name in list_variables(results)]
    variables = [v for v in variables if v]
    found = list_results(results)
    if not variables or not found:
        return None
    charts = []
    for abscissa in choose_abscissae(table, variables):
        others = [v.name for v in variables if v is not abscissa]
        charts += [make_chart(table, abscissa, others, c) for c in found]
    return section("results", "Results", make_gallery(charts))


def shorten(columns):
    """At most MOST_ROWS rows."""
    return [Column(c.name, c.unit, c.values[:MOST_ROWS], c.is_number)
            for c in columns]


def make_cases(results):
    table = results.tables["study"]
    if not table:
        return None
    count = count_rows(table)
    caption = f"All {count} cases"
    if count > MOST_ROWS:
        caption = f"The first {MOST_ROWS} of {count} cases; study.csv has all"
    shown = show_columns(caption, [c for c in shorten(table)
                                   if c.name != "reason"])
    if count > MOST_OPEN_ROWS:
        shown = tag("details", tag("summary", f"Table of {count} cases"), shown)
    return section("cases", "Cases", shown)


def make_study_plots(results):
    plots = make_plots(results.folder)
    return section("plots", "Plots of the study", plots)
