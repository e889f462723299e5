"""What became of a run, said first."""

import math

import taut_numbers as numbers

from .markup import tag
from .tables import count_rows, find_column

# Class of the banner and its headline.
HEADLINES = {
    "completed": ("completed", "✓ Completed"),
    "event": ("event", "■ Stopped by an event"),
    "interrupted": ("interrupted", "❚❚ Interrupted"),
    "failed": ("failed", "✕ Failed"),
}


def find_last_time(results):
    """The last time in the history, None without one."""
    times = find_column(results.tables["history"], "time")
    if times is None or not times.values or math.isnan(times.values[-1]):
        return None
    return times.values[-1]


def describe_unfinished(results):
    """A run that wrote no run.json: killed, or still at work."""
    time = find_last_time(results)
    until = ("It wrote no history." if time is None else
             f"Its history ends at {numbers.format_quantity(time, 's')}, after "
             f"{count_rows(results.tables['history'])} rows.")
    lines = [tag("p", "✕ Did not finish", class_="word"),
             tag("p", "There is no run.json: the run was killed, it broke off "
                      "before its end, or it is still at work. ", until,
                 " This report shows what is there.")]
    if (results.folder / "checkpoint" / "state").exists():
        lines.append(tag("p", "There is a checkpoint: the same command with ",
                         tag("code", "--resume"), " goes on from it."))
    return tag("div", lines, class_="status failed", role="status")


def get_advice(status, results):
    if status == "interrupted":
        return ["The same command with ", tag("code", "--resume"), " goes on."]
    if status == "failed":
        return ["What came before the failure is kept and shown below. The end "
                "of the log is under ", tag("a", "Run", href="#run"), "."]
    return None


def make_banner(results):
    if not results.summary:
        return describe_unfinished(results)
    status = results.summary.get("status", "failed")
    kind, headline = HEADLINES.get(status, ("failed", f"✕ {status}"))
    time = results.summary.get("time_reached")
    if isinstance(time, (int, float)) and not results.is_response():
        where = "parameter" if results.is_path() else "t"
        unit = "" if results.is_path() else "s"
        headline += f" at {where} = {numbers.format_quantity(time, unit)}"
    lines = [tag("p", headline, class_="word")]
    if results.summary.get("reason"):
        lines.append(tag("p", results.summary["reason"]))
    advice = get_advice(status, results)
    if advice:
        lines.append(tag("p", advice))
    return tag("div", lines, class_=f"status {kind}", role="status")


def make_short(results):
    """The word of the status for the title of the page."""
    if not results.summary:
        return "did not finish"
    return {"event": "stopped by an event"}.get(
        results.summary.get("status"), results.summary.get("status", "failed"))
