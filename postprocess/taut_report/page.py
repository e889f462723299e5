"""The whole page: one file that needs nothing else."""

import re
from pathlib import Path

from . import analyses, histories, run_parts, status, study_parts
from .markup import Markup, tag
from .pictures import make_pictures


def read_style():
    return Path(__file__).with_name("style.css").read_text(encoding="utf-8")


def list_sections(results, problem):
    if results.is_study():
        return [study_parts.make_failures(results),
                study_parts.make_overview(results),
                study_parts.make_study_plots(results),
                study_parts.make_results(results),
                study_parts.make_cases(results)]
    return [run_parts.make_key_facts(results) if results.summary else None,
            run_parts.make_notes(results),
            make_pictures(results, problem),
            analyses.make_modes(results),
            analyses.make_comparison(results),
            None if results.is_response() else histories.make_probes(results),
            run_parts.make_events(results),
            analyses.make_motion(results),
            analyses.make_response(results),
            None if results.is_response() else histories.make_energies(results),
            run_parts.make_parameters(results),
            run_parts.make_record(results)]


def make_contents(sections):
    """Links to the sections, from their own headings."""
    found = [re.search(r'<section id="(\w+)"><h2>(.*?)</h2>', part)
             for part in sections]
    items = [tag("li", tag("a", Markup(match[2]), href=f"#{match[1]}"))
             for match in found if match]
    return tag("nav", tag("ul", items), aria_label="Contents")


def find_title(results):
    title = results.study.get("title") or results.get_parameter("Title")
    return title or results.folder.resolve().name


def find_begin(results):
    """When the run began, by the first line of its log."""
    match = re.match(r"\d{4}-\d\d-\d\d \d\d:\d\d",
                     results.log[0] if results.log else "")
    return match[0] if match else ""


def describe_run(results):
    """"film model, dynamics, 2026-11-22 21:56, in results/dc"."""
    words = []
    if results.is_study():
        words.append("study")
    else:
        model = results.get_parameter("Model")
        words.append({"film": "finite elements", "resonator":
                      "lumped resonator", "demes": "lumped DEMES"}.get(
                          model, model))
        words.append(results.get_parameter("Procedure/Analysis"))
    words.append(find_begin(results))
    words.append(f"folder {results.folder.resolve().name}")
    return " · ".join(word for word in words if word)


def make_page(results, problem=""):
    """`problem`: why there are no pictures."""
    title = find_title(results)
    if results.is_study():
        banner, short = study_parts.make_banner(results), "study"
    else:
        banner, short = status.make_banner(results), status.make_short(results)
    sections = [part for part in list_sections(results, problem) if part]
    head = tag("head", tag("meta", charset="utf-8"),
               tag("meta", name="viewport",
                   content="width=device-width, initial-scale=1"),
               tag("meta", name="color-scheme", content="light dark"),
               tag("title", f"{title}: {short}"),
               tag("style", Markup(read_style())))
    top = tag("header", tag("p", describe_run(results), class_="kicker"),
              tag("h1", title), banner, make_contents(sections), class_="top")
    versions = (results.summary or results.study).get("versions") or {}
    made = f"Made by Taut {versions.get('taut', '')}".strip()
    body = tag("body", top, tag("main", sections),
               tag("footer", tag("p", f"{made}. All quantities in SI units "
                                      "unless a prefix is written.")))
    return "<!DOCTYPE html>\n" + tag("html", head, body, lang="en") + "\n"
