#!/usr/bin/env python3
"""The qualitative claims of both papers against the numbers of the studies.

Usage: claims.py RESULTS [FILE.md]
RESULTS holds the folders demes_04 to demes_17 and resonator_02 to resonator_15
that `taut study` wrote. Writes RESULTS/claims.csv and RESULTS/claims.md, the
latter also as FILE.md. Every verdict follows from computed numbers by the rule
of its claim: it `holds` if the rule is met under every condition looked at,
`holds if ...` names those under which it is, else it `does not hold`.
"""

import csv
import sys
from pathlib import Path

import claims_demes
import claims_demes_heated
import claims_resonator
import paper

HEAD = """# What both papers claim, and what is computed

{counts}

The table is written by `postprocess/papers/claims.py` from the CSV files of the
studies under `prm/papers/`. Each verdict follows from the numbers by the rule in
its row, under each of the conditions looked at; no number or verdict is entered
by hand. S and e of the DEMES (P1: S = 0.03, e = 0.30; P2: S = 0.3, e = 0.55), its
temperature laws and all sizes are ours; K = 1 of the DEMES, J_lim = 67 and the
equal networks of the resonator are fitted to statements of the papers. "ret" is
the range of the angle late in a run over that in tau < 15.
"""


class Results:
    """The studies below a folder, each read once."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.studies = {}

    def __getitem__(self, name):
        if name not in self.studies:
            if not (self.folder / name / "study.csv").exists():
                raise SystemExit(f"{self.folder / name} holds no study.csv: run "
                                 f"`taut study prm/papers/{name}.prm` first")
            self.studies[name] = paper.Study(self.folder / name)
        return self.studies[name]


def decide(outcomes):
    """The verdict from {condition: whether the claim is met there}."""
    if isinstance(outcomes, str):
        return outcomes
    if all(outcomes.values()):
        return "holds"
    met = [condition for condition, is_met in outcomes.items() if is_met]
    return "holds if " + "; ".join(met) if met else "does not hold"


def evaluate(results):
    """(paper, number, figure, claim, rule, numbers, verdict) of every claim."""
    rows = []
    for name, claims in (
            ("DEMES", claims_demes.CLAIMS + claims_demes_heated.CLAIMS),
            ("resonator", claims_resonator.CLAIMS)):
        for number, claim in enumerate(claims, start=1):
            numbers, outcomes = claim.compute(results)
            rows.append((name, number, claim.figure, claim.text, claim.rule,
                         numbers, decide(outcomes)))
    return rows


def write_csv(rows, file):
    with open(file, "w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(("paper", "claim", "figure", "text", "rule", "numbers",
                         "verdict"))
        writer.writerows(rows)


def count(rows):
    kinds = [row[-1].split(" if ")[0] + (" if" if " if " in row[-1] else "")
             for row in rows]
    names = {"holds": "hold", "holds if": "hold under conditions",
             "does not hold": "do not hold"}
    parts = [f"{kinds.count(kind)} {name}" for kind, name in names.items()]
    rest = len(kinds) - sum(kinds.count(kind) for kind in names)
    return (f"Of {len(rows)} claims {', '.join(parts)}, and {rest} cannot be "
            "tested.")


def make_markdown(rows):
    text = HEAD.format(counts=count(rows))
    titles = {"DEMES": "Wang et al., Sci Rep 14:15411 (2024)",
              "resonator": "Thesis on the membrane resonator"}
    for name, title in titles.items():
        text += (f"\n## {title}\n\n| # | Figure | Claim | Rule | Computed | "
                 "Verdict |\n|---|---|---|---|---|---|\n")
        for row in rows:
            if row[0] == name:
                cells = [str(cell).replace("|", "\\|") for cell in row[1:]]
                cells = [cells[0], cells[1], *cells[2:5], f"**{cells[5]}**"]
                text += "| " + " | ".join(cells) + " |\n"
    return text


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    results = Results(sys.argv[1])
    rows = evaluate(results)
    write_csv(rows, results.folder / "claims.csv")
    text = make_markdown(rows)
    for file in [results.folder / "claims.md", *map(Path, sys.argv[2:])]:
        file.write_text(text, encoding="utf-8")
    print(count(rows))


if __name__ == "__main__":
    main()
