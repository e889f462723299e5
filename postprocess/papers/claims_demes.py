"""The claims of Wang et al. (2024) on the DEMES, figures 4 to 10."""

import numpy as np
import paper
from claims_common import (Collection, count_turns, falls, find_settling_time,
                           get_range, get_window, rises, show)
from demes_rest import find_straight_fields
from demes_section import STROBE, list_parts

CLAIMS = Collection()
SETS = {1: "P1", 2: "P2", 3: "S = 0.03, e = 0.8", 4: "S = 1, e = 0.3"}
MAIN = [2, 3, 4, 5]
PAPER_STRETCHES = [1.78, 1.70, 1.63, 1.57, 1.53, 1.48, 1.45]


def get_times(history):
    return paper.OMEGA * history["time"]


def get_rest(values):
    """The mean of the last tenth."""
    return float(np.mean(values[-len(values) // 10:]))


def get_retained(study, case, begin=85, end=100):
    """Range of the angle in a window of tau over that in tau < 15."""
    history = study.read_history(case)
    times, angle = get_times(history), history["angle"]
    return (get_range(get_window(times, angle, begin, end)) /
            get_range(get_window(times, angle, 0, 15)))


def get_settling_times(study, name, share=0.05, **values):
    """Settling times (tau) to a share of the rest value, over the
    pre-stretch."""
    times = []
    for case in study.select(**values):
        history = study.read_history(case)
        times.append(find_settling_time(get_times(history), history[name],
                                        get_rest(history[name]), share))
    return times


@CLAIMS.add("4", "oscillates and settles to an equilibrium",
            "at least two turns (of 5 % of the rest angle), and within 5 % of it "
            "before tau = 1000")
def oscillates(results):
    study = results["demes_04"]
    outcomes, text = {}, ""
    for number in study.get_values("relaxation"):
        times = get_settling_times(study, "angle", relaxation=number)
        turns = []
        for case in study.select(relaxation=number):
            angle = study.read_history(case)["angle"]
            turns.append(count_turns(angle, 0.05 * get_rest(angle)))
        text += f"S={number:g}: settled at {show(times)}; "
        outcomes[f"S = {number:g}"] = bool(np.all(np.isfinite(times)) and
                                           min(turns) >= 2)
    return text.rstrip("; "), outcomes


@CLAIMS.add("4", "the final angle rises with the pre-stretch",
            "mean of the last tenth of the run rises, at every S")
def angle_rises(results):
    study = results["demes_04"]
    outcomes = {}
    for number in study.get_values("relaxation"):
        finals = [get_rest(study.read_history(case)["angle"])
                  for case in study.select(relaxation=number)]
        outcomes[f"S = {number:g}"] = rises(finals)
    return f"{finals[0]:.3f}→{finals[-1]:.3f}", outcomes


@CLAIMS.add("4", "more pre-stretch settles sooner",
            "the time to stay within 5 % falls")
def settles_sooner(results):
    study = results["demes_04"]
    found = {f"S = {number:g}": get_settling_times(study, "angle",
                                                   relaxation=number)
             for number in study.get_values("relaxation")}
    return ("; ".join(f"{name}: {show(times)}" for name, times in found.items()),
            {name: falls(times) for name, times in found.items()})


@CLAIMS.add("5", "more pre-stretch, higher peak angular velocity", "it rises")
def velocity_rises(results):
    peaks = [case["largest angular velocity"] / paper.OMEGA
             for case in results["demes_05"].cases]
    return show(peaks), {"P1": rises(peaks)}


@CLAIMS.add("6", "final xi 1.78 1.70 1.63 1.57 1.53 1.48 1.45",
            "each final value at S = 1 rounds to it")
def final_stretches(results):
    finals = [case["final inner stretch"]
              for case in results["demes_06"].select(relaxation=1, seed=0.01)]
    return (show(finals, 4),
            {"all": [round(value, 2) for value in finals] == PAPER_STRETCHES})


def get_undershoots(study, number):
    """How far xi falls below its rest value, over the pre-stretch."""
    rests = [case["final inner stretch"]
             for case in study.select(relaxation=1, seed=0.01)]
    return [rest - case["smallest inner stretch"] for rest, case in
            zip(rests, study.select(relaxation=number, seed=0.01))]


@CLAIMS.add("6", "xi oscillates at pre-stretch 2 before it settles",
            "it falls below its rest value by more than 0.001")
def stretch_oscillates(results):
    study = results["demes_06"]
    found = {f"S = {number:g}": get_undershoots(study, number)[0]
             for number in study.get_values("relaxation")}
    return ("below by " + show(found.values()),
            {name: bool(depth > 1e-3) for name, depth in found.items()})


@CLAIMS.add("6", "its amplitude is much smaller at pre-stretches 3 to 5",
            "falls below its rest value by less than half of that at 2")
def amplitude_is_smaller(results):
    study = results["demes_06"]
    found = {f"S = {number:g}": get_undershoots(study, number)
             for number in study.get_values("relaxation")}
    return ("; ".join(f"{name}: {show(depths)}"
                      for name, depths in found.items()),
            {name: bool(depths[0] > 1e-3 and max(depths[2:]) < depths[0] / 2)
             for name, depths in found.items()})


@CLAIMS.add("6", "xi settles equally fast at all pre-stretches",
            "times to 2 % within a factor of 1.5")
def settles_equally(results):
    study = results["demes_06"]
    found = {f"S = {number:g}, seed {seed:g} rad": get_settling_times(
        study, "inner stretch", 0.02, relaxation=number, seed=seed)
        for number in study.get_values("relaxation")
        for seed in study.get_values("seed")}
    return ("; ".join(f"{name}: {show(times)}" for name, times in found.items()),
            {name: bool(max(times) < 1.5 * min(times))
             for name, times in found.items()})


def list_retained(study, stretch, begin=85, end=100, **values):
    return {SETS[number]: get_retained(
        study, study.get(pre_stretch=stretch, parameters=number, **values),
        begin, end) for number in (1, 2)}


@CLAIMS.add("7a", "pre-stretch 2 shows no significant decay",
            "ret at least 0.7 at tau = 85 to 100, and at 185 to 200")
def no_decay(results):
    early = list_retained(results["demes_07"], 2)
    late = list_retained(results["demes_07"], 2, 185, 200)
    found = {f"{name} to tau = {end}": value for end, values in
             ((100, early), (200, late)) for name, value in values.items()}
    return ("; ".join(f"{name}: {value:.2f}" for name, value in found.items()),
            {name: bool(value >= 0.7) for name, value in found.items()})


@CLAIMS.add("7a", "its path is a closed, quasi-periodic loop",
            "ret at tau = 185 to 200 is at least 0.99 of that at 85 to 100")
def closed_loop(results):
    early = list_retained(results["demes_07"], 2)
    late = list_retained(results["demes_07"], 2, 185, 200)
    ratios = {name: late[name] / early[name] for name in early}
    return ("; ".join(f"{name}: {value:.2f}" for name, value in ratios.items()),
            {name: bool(value >= 0.99) for name, value in ratios.items()})


@CLAIMS.add("7b", "pre-stretch 3 decays clearly",
            "ret at most 0.5 at tau = 85 to 100")
def clear_decay(results):
    found = list_retained(results["demes_07"], 3)
    return ("; ".join(f"{name}: {value:.3f}" for name, value in found.items()),
            {name: bool(value <= 0.5) for name, value in found.items()})


@CLAIMS.add("7c, d", "pre-stretches 4 and 5 decay to rest",
            "ret at most 0.05 at tau = 85 to 100")
def decays_to_rest(results):
    found = {stretch: list_retained(results["demes_07"], stretch)
             for stretch in (4, 5)}
    return ("; ".join(f"{name}: {found[4][name]:.3f} {found[5][name]:.3f}"
                      for name in found[4]),
            {name: bool(max(found[4][name], found[5][name]) <= 0.05)
             for name in found[4]})


@CLAIMS.add("8", "the range of the angle rises from pre-stretch 2 to 4",
            "it rises over 2, 2.5, 3, 3.5, 4")
def range_rises(results):
    study = results["demes_08"]
    outcomes, texts = {}, []
    for field in study.get_values("field"):
        for number in study.get_values("relaxation"):
            ranges = [case["largest angle"] - case["smallest angle"]
                      for case in study.select(field=field, relaxation=number)]
            name = f"e = {field:g}, S = {number:g}"
            outcomes[name] = rises(ranges[:5])
            if field in (0.3, 1):
                texts.append(f"{name}: {show(ranges)}")
    return "; ".join(texts), outcomes


@CLAIMS.add("8", "flattens at high voltage and low pre-stretch",
            "the field below which the straight frame bends again exists and "
            "rises with the pre-stretch (rest states)")
def flattens(results):
    study = results["demes_14"]
    straight, bent = zip(*(find_straight_fields(study.read_history(case))
                           for case in study.select(temperature=299,
                                                    laws="softening")))
    return (f"e = {show(bent, 4)}; straight from {show(straight, 4)} on",
            {"all": rises(bent)})


class Peaks:
    """The main peaks of a response at pre-stretches 2, 3, 4, 5."""

    def __init__(self, study, **values):
        cases = [study.get(pre_stretch=stretch, **values) for stretch in MAIN]
        self.amplitudes = [case["largest amplitude"] for case in cases]
        # omega = 1 is 5 Hz.
        self.omegas = [case["main resonance"] / 5 for case in cases]


def get_peaks(results):
    return {name: Peaks(results["demes_09"], parameters=number)
            for number, name in SETS.items()}


@CLAIMS.add("9", "the peak amplitude falls with the pre-stretch", "it falls")
def peak_falls(results):
    peaks = get_peaks(results)
    return ("; ".join(f"{name}: {show(found.amplitudes)}"
                      for name, found in peaks.items()),
            {name: falls(found.amplitudes) for name, found in peaks.items()})


@CLAIMS.add("9", "the resonance frequency falls with the pre-stretch",
            "omega of the largest amplitude falls")
def resonance_falls(results):
    peaks = get_peaks(results)
    return ("; ".join(f"{name}: {show(found.omegas)}"
                      for name, found in peaks.items()),
            {name: falls(found.omegas) for name, found in peaks.items()})


@CLAIMS.add("9", "the resonance frequency is about 1.0",
            "mean over the pre-stretches between 0.9 and 1.1")
def resonance_is_one(results):
    means = {name: float(np.mean(found.omegas))
             for name, found in get_peaks(results).items()}
    return ("; ".join(f"{name}: {mean:.2f}" for name, mean in means.items()),
            {name: bool(0.9 < mean < 1.1) for name, mean in means.items()})


def get_spreads(study, case):
    """Extent of the stroboscopic angles in each part of the section."""
    angle = study.read_history(case)["angle"][::STROBE]
    return [get_range(angle[first:last + 1])
            for first, last in list_parts(len(angle) - 1)]


def describe_section(study, case):
    exponent = case["Lyapunov exponent"] / paper.OMEGA
    return (f"spread {show(get_spreads(study, case), 2)}, exponent "
            f"{exponent:.4f}, {case['class']}")


def judge_dispersion(study, stretch):
    texts, outcomes = [], {}
    for number in (1, 2):
        case = study.get(pre_stretch=stretch, parameters=number)
        first, _, last = get_spreads(study, case)
        texts.append(f"{SETS[number]}: {describe_section(study, case)}")
        outcomes[f"{SETS[number]}, only the first 30 periods count"] = \
            bool(first > 0.05)
        outcomes[SETS[number]] = bool(last > 0.9 * first)
    return "; ".join(texts), outcomes


@CLAIMS.add("10a", "omega = 1, pre-stretch 2: a closed loop",
            "points spread by more than 0.05 in periods 1 to 30; as much in 61 "
            "to 100")
def section_is_loop(results):
    return judge_dispersion(results["demes_10"], 2)


@CLAIMS.add("10b", "pre-stretch 3: dispersed", "likewise")
def section_is_dispersed(results):
    return judge_dispersion(results["demes_10"], 3)


@CLAIMS.add("10c, d", "pre-stretch 4: a straight line, 5: a closed loop",
            "both spread by more than 0.01 in periods 61 to 100")
def section_is_line(results):
    study = results["demes_10"]
    texts, outcomes = [], {}
    for number in (1, 2):
        spreads = [get_spreads(study, study.get(pre_stretch=stretch,
                                                parameters=number))
                   for stretch in (4, 5)]
        texts.append(f"{SETS[number]}: " + " and ".join(show(spread, 2)
                                                        for spread in spreads))
        outcomes[SETS[number]] = min(spread[-1] for spread in spreads) > 0.01
    return "; ".join(texts), outcomes
