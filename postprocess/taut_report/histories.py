"""Probes, energies and margins over time, or over the parameter of a path."""

import math

from . import markup
from .charts import Axis, Chart, Mark, Series, find_finite, make_gallery
from .markup import section, tag
from .tables import find_column

# Not probes, though they stand among them.
BOOK_KEEPING = {"time", "arc length", "negative eigenvalues"}
# Energies that differ by more are not drawn in one chart.
SAME_SIZE = 20.0
# Swings are counted by their turns.
MANY_TURNS, LAST_TURNS = 160, 16


def get_times(results):
    """The first column: time, of a path its parameter, of a response its
    frequency."""
    return results.tables["history"][0]


def is_margin(column):
    return column.name.startswith("margin ")


def list_probes(columns):
    return [c for c in columns[1:] if c.is_number and not c.is_empty()
            and c.unit != "J" and not is_margin(c)
            and c.name not in BOOK_KEEPING]


def list_energies(columns):
    """All but those that are zero throughout, and not what they add up to."""
    return [c for c in columns if c.unit == "J" and c.name != "energy balance"
            and any(find_finite(c.values))]


def make_x_axis(results):
    times = get_times(results)
    if results.is_path():
        return Axis("parameter", "", times.values)
    return Axis(times.name, times.unit, times.values)


def make_ways(results):
    """Of a path: unstable parts dashed, jumps at one parameter dotted."""
    history = results.tables["history"]
    eigenvalues = find_column(history, "negative eigenvalues")
    if eigenvalues is None:
        return None
    parameters = get_times(results).values
    ways = ["--" if value > 0 else "-" for value in eigenvalues.values]
    for row in range(1, len(ways)):
        if math.isclose(parameters[row - 1], parameters[row], rel_tol=1e-9,
                        abs_tol=1e-12):
            ways[row] = ":"
    return ways


def make_marks(results):
    """Events by the time they happened."""
    events = results.tables["events"]
    times = find_column(events, "time")
    names = find_column(events, "event")
    kinds = find_column(events, "kind")
    if times is None or names is None:
        return []
    return [Mark(time, (name or kind).replace("_", " "))
            for time, name, kind in zip(times.values, names.values,
                                        kinds.values)
            if math.isfinite(time)]


def make_chart(results, column, marks):
    return Chart(column.name, make_x_axis(results), column.unit,
                 [Series(column.name, column.values, make_ways(results))],
                 marks)


def count_turns(values):
    """How often a history goes up after down or down after up."""
    steps = [b - a for a, b in zip(values, values[1:]) if b != a]
    return sum(a * b < 0 for a, b in zip(steps, steps[1:]))


def make_end(results, column):
    """The last few swings of a history that has too many to be told apart."""
    turns = count_turns(find_finite(column.values))
    if results.is_path() or turns < MANY_TURNS:
        return []
    rows = max(round(len(column.values) * LAST_TURNS / turns), 2)
    axis = make_x_axis(results)
    axis.values = axis.values[-rows:]
    return [Chart(f"{column.name}, at the end", axis, column.unit,
                  [Series(column.name, column.values[-rows:])])]


def make_charts(results, probes, marks):
    charts = []
    for column in probes:
        charts.append(make_chart(results, column, marks))
        charts += make_end(results, column)
    return charts


def make_extremes(column):
    finite = find_finite(column.values) or [math.nan]
    return [markup.quantity(value, column.unit)
            for value in (finite[0], min(finite), max(finite), finite[-1])]


def explain(results, marks):
    words = []
    if marks:
        words.append("Vertical lines: events.")
    if results.is_path():
        words.append("Solid: stable; dashed: unstable; dotted: jumps.")
    return tag("p", " ".join(words)) if words else None


def make_probes(results):
    probes = list_probes(results.tables["history"])
    if not probes:
        return None
    marks = make_marks(results)
    rows = [[c.name, *make_extremes(c)] for c in probes]
    return section(
        "histories", "Histories",
        make_gallery(make_charts(results, probes, marks)),
        explain(results, marks),
        markup.table("Probes from the first to the last row of history.csv",
                     ["Probe", "First", "Lowest", "Highest", "Last"], rows,
                     "tnnnn"))


def group_by_size(columns):
    """Groups within SAME_SIZE, the largest first."""
    groups = []
    for column in sorted(columns, reverse=True, key=lambda c: max(
            map(abs, find_finite(c.values)))):
        top = max(map(abs, find_finite(column.values)))
        if groups and groups[-1][0] <= SAME_SIZE * top:
            groups[-1][1].append(column)
        else:
            groups.append((top, [column]))
    return [sorted(group, key=lambda c: c.name) for _, group in groups]


def name_group(group):
    if len(group) == 1:
        return group[0].name
    return "energies"


def describe_balance(results):
    """What run.json says of the energy balance."""
    balance = results.summary.get("energy_balance") or {}
    absolute, relative = balance.get("absolute"), balance.get("relative")
    if absolute is None and relative is None:
        return None
    words = ["Energy balance: the largest residual is "]
    if absolute is not None:
        words.append(markup.quantity(absolute, "J"))
    if relative is not None:
        words += [" or ", markup.number(relative),
                  " of the largest energy that changed"]
    return tag("p", words, ".")


def make_energies(results):
    history = results.tables["history"]
    energies = list_energies(history)
    charts = [Chart(name_group(group), make_x_axis(results), "J",
                    [Series(c.name, c.values) for c in group],
                    note=" " if len(group) > 1 else "")
              for group in group_by_size(energies)]
    balance = find_column(history, "energy balance")
    # Equilibria are not balanced: their source is not followed.
    is_balanced = not results.summary or (results.summary.get(
        "energy_balance") or {}).get("absolute") is not None
    if balance and is_balanced and any(find_finite(balance.values)):
        charts.append(Chart("residual of the energy balance",
                            make_x_axis(results), "J",
                            [Series(balance.name, balance.values)]))
    return section("energies", "Energies", describe_balance(results),
                   make_gallery(charts) if charts else None)


def make_margins(results):
    """Charts of the margins of the events."""
    margins = [c for c in results.tables["history"]
               if is_margin(c) and not c.is_empty()]
    if not margins:
        return None
    chart = Chart("margins", make_x_axis(results), "",
                  [Series(c.name.removeprefix("margin "), c.values)
                   for c in margins],
                  make_marks(results), note="1 far from the event, 0 as it "
                  "happens" if len(margins) > 1 else "")
    if len(margins) == 1:
        chart.title = margins[0].name
    return make_gallery([chart])
