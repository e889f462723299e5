"""The claims of Wang et al. (2024) on the heated DEMES, figures 11 to 17, and the
one on the best pre-stretch."""

import numpy as np
import paper
from claims_common import (Collection, falls, falls_where_reached, get_range,
                           get_window, rises, show)
from claims_demes import (MAIN, SETS, Peaks, describe_section, get_retained,
                          get_settling_times, get_spreads, get_times,
                          list_retained)

CLAIMS = Collection()
TEMPERATURES = [320, 340, 360]
# Of the temperature laws `softening`: mu falls by 0.5 % a kelvin.
SOFTENING = 0.005


def get_rest_table(results, laws, name):
    """{pre-stretch: values over the temperature} of the rest states."""
    study = results["demes_14"]
    return {stretch: study.get_curve("temperature", name, laws=laws,
                                     pre_stretch=stretch)[1]
            for stretch in study.get_values("pre_stretch")}


def show_ends(table):
    return " ".join(f"{stretch:g}: {values[0]:.3f}→{values[-1]:.3f}"
                    for stretch, values in table.items()
                    if stretch in (2, 5))


@CLAIMS.add("11, 14", "the rest angle rises with the temperature",
            "it rises from 299 to 360 K at every pre-stretch")
def angle_rises(results):
    tables = {laws: get_rest_table(results, laws, "rest angle")
              for laws in results["demes_14"].get_values("laws")}
    return ("; ".join(f"{laws} laws: {show_ends(table)}"
                      for laws, table in tables.items()),
            {f"{laws} laws": all(rises(values) for values in table.values())
             for laws, table in tables.items()})


@CLAIMS.add("11, 14", "the rest angle rises with the pre-stretch",
            "at every temperature")
def angle_rises_with_stretch(results):
    outcomes = {}
    for laws in results["demes_14"].get_values("laws"):
        table = np.array(list(get_rest_table(results, laws,
                                             "rest angle").values()))
        outcomes[f"{laws} laws"] = all(rises(column) for column in table.T)
    table = get_rest_table(results, "softening", "rest angle")
    return (f"320 K: {show([values[1] for values in table.values()])}",
            outcomes)


@CLAIMS.add("11", "settles sooner with more pre-stretch",
            "the time to stay within 5 % falls at every temperature (P1); what "
            "takes longer than tau = 1000 stands first")
def settles_sooner(results):
    found = {f"{temperature} K": get_settling_times(
        results["demes_11"], "angle", temperature=temperature)
        for temperature in TEMPERATURES}
    return ("; ".join(f"{name}: {show(times)}" for name, times in found.items()),
            {name: falls_where_reached(times)
             for name, times in found.items()})


def get_late_amplitude(study, name, factor=1, begin=85, end=100, **values):
    history = study.read_history(study.get(**values))
    return factor * get_range(get_window(get_times(history), history[name],
                                         begin, end)) / 2


@CLAIMS.add("12", "pre-stretch 2 is unattenuated at 320 K and swings more at 340 "
            "and 360 K", "amplitude of the angle in tau = 85 to 100 rises with "
            "the temperature, and at 320 K is at least 0.7 of that in 5 to 20")
def swings_more_when_hot(results):
    study = results["demes_11"]
    late = [get_late_amplitude(study, "angle", pre_stretch=2, temperature=t)
            for t in TEMPERATURES]
    early = get_late_amplitude(study, "angle", 1, 5, 20, pre_stretch=2,
                               temperature=320)
    return (f"{show(late)}; 320 K early {early:.3f}",
            {"all": rises(late) and late[0] > 0.7 * early})


@CLAIMS.add("12", "the peak angular velocity falls with the pre-stretch",
            "at every temperature")
def velocity_falls(results):
    study = results["demes_12"]
    peaks = {f"{t} K": [case["largest angular velocity"] / paper.OMEGA
                        for case in study.select(temperature=t)]
             for t in TEMPERATURES}
    return (f"320 K: {show(peaks['320 K'])}",
            {name: falls(values) for name, values in peaks.items()})


@CLAIMS.add("12", "pre-stretches 3 and more: the angular velocity dies out",
            "its amplitude in tau = 85 to 100 is less than in 15 to 30, at every "
            "temperature")
def velocity_dies_out(results):
    study = results["demes_12"]
    outcomes, text = {}, ""
    for temperature in TEMPERATURES:
        late, early = ([get_late_amplitude(
            study, "angular velocity", 1 / paper.OMEGA, begin, end,
            pre_stretch=stretch, temperature=temperature)
            for stretch in MAIN[1:]] for begin, end in ((85, 100), (15, 30)))
        text += f"{temperature} K: {show(early)} → {show(late)}; "
        outcomes[f"{temperature} K"] = bool(np.all(np.array(late) < early))
    return text.rstrip("; "), outcomes


@CLAIMS.add("13", "xi at rest falls with the temperature and with the "
            "pre-stretch", "both, of the rest states")
def stretch_falls(results):
    outcomes, text = {}, ""
    for laws in results["demes_14"].get_values("laws"):
        table = get_rest_table(results, laws, "rest stretch")
        text += f"{laws} laws: {show_ends(table)}; "
        columns = np.array(list(table.values())).T
        outcomes[f"{laws} laws"] = (
            all(falls(values) for values in table.values()) and
            all(falls(column) for column in columns))
    return text.rstrip("; "), outcomes


@CLAIMS.add("15a", "pre-stretch 2 at 320 K decays, some motion stays",
            "ret at tau = 85 to 100 between 0.2 and 0.95")
def some_stays(results):
    found = list_retained(results["demes_15"], 2, temperature=320)
    return ("; ".join(f"{name}: {value:.2f}" for name, value in found.items()),
            {name: bool(0.2 < value < 0.95) for name, value in found.items()})


@CLAIMS.add("15d-f", "pre-stretch 3 decays faster than 2", "smaller ret")
def three_decays_faster(results):
    texts, outcomes = [], {}
    for temperature in TEMPERATURES:
        two, three = (list_retained(results["demes_15"], stretch,
                                    temperature=temperature)
                      for stretch in (2, 3))
        for name in two:
            texts.append(f"{name} {temperature} K: {three[name]:.2f} against "
                         f"{two[name]:.2f}")
            outcomes[f"{name} {temperature} K"] = bool(three[name] < two[name])
    return "; ".join(texts), outcomes


@CLAIMS.add("15d-f", "pre-stretch 3 has a lower peak velocity than 2",
            "at every temperature")
def three_is_slower(results):
    study, texts, outcomes = results["demes_15"], [], {}
    for number in (1, 2):
        for temperature in TEMPERATURES:
            two, three = (study.get(pre_stretch=stretch, parameters=number,
                                    temperature=temperature)
                          ["largest angular velocity"] / paper.OMEGA
                          for stretch in (2, 3))
            name = f"{SETS[number]} {temperature} K"
            texts.append(f"{name}: {three:.4f} against {two:.4f}")
            outcomes[name] = bool(three < two)
    return "; ".join(texts), outcomes


@CLAIMS.add("15g-l", "pre-stretches 4 and 5 die out",
            "ret at most 0.05 at tau = 185 to 200")
def four_and_five_die_out(results):
    study, texts, outcomes = results["demes_15"], [], {}
    for number in (1, 2):
        for temperature in TEMPERATURES:
            cases = [study.get(pre_stretch=stretch, parameters=number,
                               temperature=temperature) for stretch in (4, 5)]
            late = [get_retained(study, case, 185, 200) for case in cases]
            name = f"{SETS[number]} {temperature} K"
            early = show([get_retained(study, case) for case in cases], 2)
            texts.append(f"{name}: {show(late, 2)} (at 85 to 100: {early})")
            outcomes[name] = max(late) <= 0.05
    return "; ".join(texts), outcomes


def get_peaks(results, laws="softening"):
    return {temperature: Peaks(results["demes_16"], temperature=temperature,
                               laws=laws) for temperature in TEMPERATURES}


def get_scaled_omegas(peaks):
    """omega of pre-stretches 3, 4, 5 over temperature (rows), in the paper's own
    unit of time, which follows mu(T)."""
    return np.array([np.array(found.omegas[1:]) /
                     np.sqrt(1 - SOFTENING * (temperature - 299))
                     for temperature, found in peaks.items()])


@CLAIMS.add("16", "the resonance frequency falls with the temperature",
            "omega of the largest amplitude falls at pre-stretches 3, 4, 5 (the "
            "motions at 2 pass the straight frame: they depend on the last "
            "digit)")
def resonance_falls_when_hot(results):
    tables = {f"{laws} laws, fixed unit of time": np.array(
        [found.omegas[1:] for found in get_peaks(results, laws).values()])
        for laws in ("softening", "entropic")}
    tables["softening laws, unit of time with mu(T)"] = \
        get_scaled_omegas(get_peaks(results))
    return ("; ".join(f"{name}: " + ", ".join(show(column)
                                              for column in table.T)
                      for name, table in tables.items()),
            {name: all(falls(column) for column in table.T)
             for name, table in tables.items()})


@CLAIMS.add("16", "the amplitude falls with the temperature",
            "largest amplitude, at pre-stretches 3, 4, 5")
def amplitude_falls_when_hot(results):
    tables = {f"{laws} laws": np.array(
        [found.amplitudes[1:] for found in get_peaks(results, laws).values()])
        for laws in ("softening", "entropic")}
    return ("; ".join(f"{name}: " + ", ".join(show(column)
                                              for column in table.T)
                      for name, table in tables.items()),
            {name: all(falls(column) for column in table.T)
             for name, table in tables.items()})


@CLAIMS.add("16", "frequency and amplitude fall with the pre-stretch",
            "at every temperature")
def both_fall(results):
    peaks = get_peaks(results)
    return ("; ".join(f"{t} K: omega {show(found.omegas)}, amplitude "
                      f"{show(found.amplitudes)}"
                      for t, found in peaks.items()),
            {"of the frequency": all(falls(found.omegas)
                                     for found in peaks.values()),
             "of the amplitude": all(falls(found.amplitudes)
                                     for found in peaks.values())})


@CLAIMS.add("17", "the mean resonance frequency is 1.5",
            "mean over the pre-stretches between 1.4 and 1.6")
def mean_is_one_and_a_half(results):
    means = {f"{t} K": float(np.mean(found.omegas))
             for t, found in get_peaks(results).items()}
    return ("; ".join(f"{name}: {mean:.2f}" for name, mean in means.items()),
            {name: bool(1.4 < mean < 1.6) for name, mean in means.items()})


@CLAIMS.add("10, 15, 17", "the motion turns from non-periodic over "
            "quasi-periodic to periodic with temperature and pre-stretch",
            "a motion that is not periodic lasts: its Lyapunov exponent is "
            "positive by three uncertainties, or its points keep their spread "
            "from periods 101 to 200 to periods 201 to 300 within 5 %")
def motion_turns(results):
    study, texts, outcomes = results["demes_17"], [], {}
    for temperature in TEMPERATURES:
        for stretch in MAIN:
            case = study.get(pre_stretch=stretch, temperature=temperature)
            name = f"pre-stretch {stretch}, {temperature} K"
            texts.append(f"{name}: {describe_section(study, case)}")
            _, before, last = get_spreads(study, case)
            stays = case["class"] != "periodic" and last > 0.95 * before
            outcomes[name] = bool(stays or case["Lyapunov exponent"] >
                                  3 * case["Lyapunov uncertainty"])
    return "; ".join(texts), outcomes


@CLAIMS.add("-", "pre-stretches 2.5 to 3 are the best range",
            "none: the paper gives no measure of best")
def best_range(_):
    return "", "cannot be tested"
