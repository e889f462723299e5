"""Events, parameters and the record of a run."""

import math

import taut_numbers as numbers

from . import histories, markup
from .markup import section, tag
from .tables import count_rows, find_column

MOST_EVENTS = 200
LAST_LINES = 12
COUNTERS = {"rejected_by_error": "steps rejected by their error",
            "rejected_by_newton": "steps rejected by Newton's method",
            "flat_negative_eigenvalues": "negative eigenvalues, flat",
            "rest_shape_negative_eigenvalues":
                "negative eigenvalues, rest shape"}


def get_text(columns, name, row):
    column = find_column(columns, name)
    return column.values[row] if column else ""


def get_value(columns, name, row):
    column = find_column(columns, name)
    return column.values[row] if column and column.is_number else math.nan


def describe_place(events, row):
    """"film, (12.1, 26.8, 0) mm"."""
    words = [get_text(events, "place", row)]
    place = [get_value(events, axis, row) for axis in "xyz"]
    if all(map(math.isfinite, place)):
        inside = ", ".join(numbers.format_number(1e3 * x, 3)
                           if abs(x) > 1e-12 else "0" for x in place)
        words.append(f"({inside}) mm")
    return ", ".join(word for word in words if word)


def make_event_row(results, row):
    events = results.tables["events"]
    unit = "" if results.is_path() else "s"
    kind = get_text(events, "kind", row).replace("_", " ")
    fatal = get_text(events, "fatal", row) == "true"
    return [get_text(events, "event", row) or kind,
            markup.quantity(get_value(events, "time", row), unit), kind,
            describe_place(events, row),
            markup.number(get_value(events, "value", row)),
            markup.number(get_value(events, "threshold", row)),
            "ends the run" if fatal else ""]


def make_events(results):
    events = results.tables["events"]
    count = count_rows(events)
    margins = histories.make_margins(results)
    if not count:
        if not margins:
            return None
        return section("events", "Events", tag("p", "No event happened."),
                       margins)
    rows = [make_event_row(results, row)
            for row in range(min(count, MOST_EVENTS))]
    caption = "Events in their order; places in the mesh, values in SI units"
    if count > MOST_EVENTS:
        caption += f"; the first {MOST_EVENTS} of {count}"
    when = "At parameter" if results.is_path() else "At time"
    return section("events", "Events", markup.table(
        caption, ["Event", when, "Kind", "Place", "Value", "Threshold", ""],
        rows, "tnttnnt"), margins)


def group_changes(changed):
    """Section to [(key, values)], in the order of the file."""
    groups = {}
    for path, values in changed.items():
        head, _, key = path.rpartition("/")
        groups.setdefault(head, []).append((key, path, values))
    return groups


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def make_parameter_row(key, values, known):
    """The unit behind numbers; in words such as table(0: 0) it is clear."""
    value, default = values.get("value", ""), values.get("default", "")
    unit = numbers.write_unit(known.unit) if known else ""
    is_plain = all(map(is_number, value.split(",")))
    return tag("tr", tag("th", key, scope="row"),
               tag("td", f"{value} {unit}" if unit and is_plain else value),
               tag("td", default, class_="default"))


def make_parameters(results):
    changed = results.summary.get("parameters_changed") or {}
    if not changed:
        return None
    rows = []
    for head, entries in group_changes(changed).items():
        if head:
            rows.append(tag("tr", tag("th", head.replace("/", " › "),
                                      colspan=3, scope="colgroup"),
                            class_="group"))
        rows += [make_parameter_row(key, values, results.parameters.get(path))
                 for key, path, values in entries]
    head = tag("tr", [tag("th", word, scope="col")
                      for word in ("Parameter", "Value", "Default")])
    caption = "Parameters that differ from their defaults"
    return section("parameters", "Parameters", tag(
        "div", tag("table", tag("caption", caption), tag("thead", head),
                   tag("tbody", rows)),
        class_="scroll stack", tabindex="0", role="region",
        aria_label=caption))


def make_notes(results):
    notes = results.summary.get("notes") or []
    if not notes:
        return None
    return section("notes", "Notes",
                   tag("ul", [tag("li", note) for note in notes]))


def name_counter(key):
    return COUNTERS.get(key, key.replace("_", " "))


def make_pairs(caption, head, pairs):
    return markup.table(caption, head, [[a, b] for a, b in pairs], "tn")


def make_log(results):
    lines = results.log[-LAST_LINES:]
    if not lines:
        return None
    is_bad = results.summary.get("status") in (None, "failed")
    return tag("details", tag("summary", "End of the log"),
               tag("pre", "\n".join(lines)), open=is_bad)


def make_record(results):
    summary = results.summary
    parts = []
    counters = summary.get("counters") or {}
    if counters:
        parts.append(make_pairs("Counters", ["Counter", "Count"], [
            (name_counter(key), markup.number(value, 7))
            for key, value in counters.items()]))
    timings = dict(summary.get("timings") or {})
    pairs = [(key.replace("_", " "), markup.quantity(value, "s"))
             for key, value in timings.items()]
    if summary.get("peak_memory_bytes"):
        pairs.append(("peak memory",
                      f"{summary['peak_memory_bytes'] / 2**20:.0f} MiB"))
    if pairs:
        parts.append(make_pairs("Time and memory", ["Part", "Used"], pairs))
    versions = summary.get("versions") or {}
    if versions:
        parts.append(markup.table("Versions", ["Library", "Version"],
                                  list(map(list, versions.items()))))
    columns = tag("div", parts, class_="columns") if parts else None
    return section("run", "Run", columns, make_log(results))


def make_key_facts(results):
    """What is looked for first."""
    summary, pairs = results.summary, []
    counters = summary.get("counters") or {}
    if "time_reached" in summary and not (results.is_path()
                                          or results.is_response()):
        pairs.append(("time reached",
                      markup.quantity(summary["time_reached"], "s")))
    total = (summary.get("timings") or {}).get("total")
    if total is not None:
        pairs.append(("wall time", markup.quantity(total, "s", 3)))
    for key, name in (("unknowns", "unknowns"), ("steps", "steps")):
        if key in counters:
            pairs.append((name, markup.number(counters[key], 7)))
    ranks = summary.get("ranks")
    if ranks and ranks > 1:
        pairs.append(("MPI ranks", ranks))
    pairs.append(("events", count_rows(results.tables["events"])))
    relative = (summary.get("energy_balance") or {}).get("relative")
    if relative is not None and not results.is_response():
        pairs.append(("energy balance, relative", markup.number(relative, 2)))
    return section("overview", "Overview", markup.facts(pairs))
