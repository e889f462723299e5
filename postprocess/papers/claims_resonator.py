"""The claims of the thesis on the membrane resonator."""

import numpy as np
import paper
from claims_common import Collection, count_turns, falls, rises, show

CLAIMS = Collection()
THREE, SLOW, PAIR = "0.01, 1, 100", "0.01, 100", "0.01, 1"
ON = 1000  # the voltage of figures 3.10 to 3.12 begins to rise (s)


def get_failure(study, **values):
    """V*, lambda_1A and Omega_n at the failure of a case."""
    case = study.get(**values)
    return np.array([case["voltage at failure"] / paper.VOLTAGE,
                     case["stretch at failure"],
                     case["frequency at failure"] / paper.FREQUENCY])


def get_omega(history):
    return history["natural frequency"] / paper.FREQUENCY


def find_arrival(history, share=0.01):
    """Time since the ramp began from which on the frequency stays within a share
    of its last value (s)."""
    omega = get_omega(history)
    outside = np.flatnonzero(np.abs(omega / omega[-1] - 1) > share)
    return history["time"][outside[-1]] - ON


@CLAIMS.add("3.2", "stretch of the active strip grows steadily with the voltage",
            "lambda_1A rises from row to row in every run")
def stretch_is_monotone(results):
    study = results["resonator_02"]
    smallest = [np.min(np.diff(study.read_history(case)["stretch active"]))
                for case in study.cases]
    return (f"smallest step {min(smallest):.1e} in {len(smallest)} runs",
            {"all": min(smallest) > 0})


@CLAIMS.add("3.2, 3.3", "three networks sustain more voltage, stretch and "
            "frequency than one", "all three are higher at the failure")
def three_sustain_more(results):
    study = results["resonator_03"]
    texts, outcomes = [], {}
    for share in study.get_values("share"):
        one = get_failure(study, share=share, times=1.0)
        three = get_failure(study, share=share, times=THREE)
        texts.append(f"chi={share:g}: V* {one[0]:.4f}→{three[0]:.4f}, lambda "
                     f"{one[1]:.3f}→{three[1]:.3f}, Omega {one[2]:.2f}→"
                     f"{three[2]:.2f}")
        outcomes[f"chi = {share:g}"] = bool(np.all(three > one))
    return "; ".join(texts), outcomes


def describe_minima(study, times):
    texts, turns = [], []
    for share in study.get_values("share"):
        history = study.read_history(study.get(share=share, times=times))
        omega = get_omega(history)
        turns.append(count_turns(omega, 1e-3))
        lowest = np.argmin(omega)
        texts.append(f"chi={share:g}: {turns[-1]} turns, lowest "
                     f"{omega[lowest]:.3f} at "
                     f"{history['voltage'][lowest] / paper.VOLTAGE:.3f}")
    return "; ".join(texts), turns


@CLAIMS.add("3.3", "with one network the frequency falls, then rises",
            "exactly one turn (of more than 0.001)")
def one_minimum(results):
    text, turns = describe_minima(results["resonator_03"], 1.0)
    return text, {"all": all(n == 1 for n in turns)}


@CLAIMS.add("3.3", "with three it is less simple", "more than one turn")
def more_turns(results):
    text, turns = describe_minima(results["resonator_03"], THREE)
    return text, {"all": all(n > 1 for n in turns)}


@CLAIMS.add("3.2, 3.3", "one and three networks come closer as chi grows",
            "the relative difference of V_f* falls with chi")
def closer_with_share(results):
    study = results["resonator_02"]
    gaps = [get_failure(study, share=share, times=THREE)[0] /
            get_failure(study, share=share, times=1.0)[0] - 1
            for share in study.get_values("share")]
    return f"{show([100 * gap for gap in gaps])} %", {"all": falls(gaps)}


@CLAIMS.add("3.2", "the device fails by loss of tension, along it or across it",
            "every run ends with one of the two, and both occur")
def tension_is_lost(results):
    study = results["resonator_02"]
    reasons = [case["reason"] for case in study.cases]
    across = sum("x_2" in reason for reason in reasons)
    return (f"{len(reasons) - across} along, {across} across",
            {"all": 0 < across < len(reasons) and
             all("loss of tension" in reason for reason in reasons)})


@CLAIMS.add("3.4", "larger chi: higher voltage and stretch",
            "both are higher at the failure for chi = 0.5 than for 0.1")
def share_helps(results):
    study = results["resonator_04"]
    low = get_failure(study, share=0.1, times=0.01)
    high = get_failure(study, share=0.5, times=0.01)
    return (f"{low[0]:.4f}/{low[1]:.3f}→{high[0]:.4f}/{high[1]:.3f}",
            {"all": bool(np.all(high[:2] > low[:2]))})


def compare_slow(study):
    slow = get_failure(study, share=0.1, times=SLOW)
    stiff = get_failure(study, share=0.5, times=0.01)
    text = (f"V*, lambda, Omega at the failure {show(slow, 4)} against "
            f"{show(stiff, 4)}")
    return text, {"all": bool(np.all(np.abs(slow / stiff - 1) < 0.05))}


@CLAIMS.add("3.4, 3.5", "a slow network beside the fast one makes chi = 0.1 "
            "nearly chi = 0.5", "V*, lambda and Omega at the failure within 5 %")
def slow_network_stiffens(results):
    return compare_slow(results["resonator_05"])


@CLAIMS.add("3.6, 3.7", "the same at the rate 10",
            "V*, lambda and Omega at the failure within 5 %")
def slow_network_stiffens_fast(results):
    return compare_slow(results["resonator_07"])


@CLAIMS.add("3.2 to 3.7", "more viscous devices fail earlier",
            "V_f* rises with chi at the same networks and rate")
def viscosity_weakens(results):
    outcomes, texts = {}, []
    for name, times in (("resonator_02", 1.0), ("resonator_02", THREE),
                        ("resonator_04", 0.01), ("resonator_06", 0.01)):
        found = sorted((case["share"], case["voltage at failure"])
                       for case in results[name].select(times=times))
        voltages = [voltage / paper.VOLTAGE for _, voltage in found]
        texts.append(show(voltages, 4))
        outcomes[f"{name}, T = {times}"] = rises(voltages)
    return "; ".join(texts), outcomes


NETWORKS = {"T = 0.01 s (caption)": 0.01, "T = 1 s (text)": 1.0}


@CLAIMS.add("3.8", "a single network withstands more than two at the rate 10",
            "V_f* is higher than with two, for both chi")
def single_withstands_more(results):
    study = results["resonator_08"]
    two = [get_failure(study, share=share, times=PAIR)[0]
           for share in (0.1, 0.5)]
    texts, outcomes = [f"two {show(two)}"], {}
    for name, times in NETWORKS.items():
        one = [get_failure(study, share=share, times=times)[0]
               for share in (0.1, 0.5)]
        texts.append(f"{name} {show(one)}")
        outcomes[name] = bool(np.all(np.array(one) > two))
    return "; ".join(texts), outcomes


@CLAIMS.add("3.8, 3.9", "a single network does not care for chi, two do",
            "V_f* changes by less than 5 % with one, by more with two")
def single_ignores_share(results):
    study = results["resonator_08"]

    def get_change(times):
        return (get_failure(study, share=0.5, times=times)[0] /
                get_failure(study, share=0.1, times=times)[0] - 1)
    two = get_change(PAIR)
    ones = {name: get_change(times) for name, times in NETWORKS.items()}
    text = "; ".join(f"{name} {100 * one:.2g} %" for name, one in ones.items())
    return (f"two {100 * two:.2g} %; {text}",
            {name: bool(one < 0.05 < two) for name, one in ones.items()})


@CLAIMS.add("3.10a", "both reach the same steady frequency before the voltage",
            "Omega at 1000 s differs by less than 0.1 %")
def same_before(results):
    omega = [case["frequency before"] / paper.FREQUENCY
             for case in results["resonator_10"].cases]
    at_end = [get_omega(history)[history["time"] == ON][0] for history in
              map(results["resonator_10"].read_history,
                  results["resonator_10"].cases)]
    return (show(at_end, 5), {"all": abs(at_end[1] / at_end[0] - 1) < 1e-3 and
                              len(omega) == 2})


@CLAIMS.add("3.10, 3.13", "V* = 0.2 is safe",
            "the voltage that can be held exceeds it at every rate")
def is_safe(results):
    limits = [case["hold limit"] / paper.VOLTAGE
              for case in results["resonator_13"].cases]
    return (f"{min(limits):.4f} to {max(limits):.4f}",
            {"all": min(limits) > 0.2})


@CLAIMS.add("3.10b", "on the ramp the frequency first falls, then rises",
            "one turn (of more than 0.001), below both ends")
def falls_then_rises(results):
    study = results["resonator_10"]
    texts, outcomes = [], {}
    for case in study.cases:
        history = study.read_history(case)
        ramp = (history["time"] >= ON) & (history["time"] <= ON + 0.666668)
        omega = get_omega(history)[ramp]
        lowest = np.argmin(omega)
        texts.append(f"T={case['times']}: {omega[0]:.3f}→{omega[lowest]:.3f} (V*="
                     f"{history['voltage'][ramp][lowest] / paper.VOLTAGE:.3f})→"
                     f"{omega[-1]:.3f}")
        outcomes[f"T = {case['times']}"] = count_turns(omega, 1e-3) == 1
    return "; ".join(texts), outcomes


@CLAIMS.add("3.10c", "same final state, sooner with three networks than with "
            "100 s", "Omega within 0.1 %, time to 1 % shorter")
def same_final_state(results):
    study = results["resonator_10"]
    histories = [study.read_history(study.get(times=times))
                 for times in (100.0, THREE)]
    final = [get_omega(history)[-1] for history in histories]
    times = [find_arrival(history) for history in histories]
    return (f"Omega {show(final, 5)}; {times[0]:.0f} s and {times[1]:.0f} s",
            {"all": abs(final[1] / final[0] - 1) < 1e-3 and
             times[1] < times[0]})


@CLAIMS.add("3.11", "the networks set the time of tuning",
            "times to 1 % differ by more than ten times")
def time_is_tuned(results):
    study = results["resonator_11"]
    times = {case["times"]: find_arrival(study.read_history(case))
             for case in study.cases}
    text = ", ".join(f"T={name}: {time:.0f} s" for name, time in times.items())
    return text, {"all": max(times.values()) > 10 * min(times.values())}


@CLAIMS.add("3.11", "the number of networks is irrelevant for the steady state, "
            "which the ground network alone governs",
            "final Omega within 0.1 %; Omega without the networks' share "
            "(1 - chi)(1 + k) 4/lambda^2 within 5 % of Omega before the voltage")
def steady_state(results):
    study = results["resonator_11"]
    final = [case["final frequency"] / paper.FREQUENCY for case in study.cases]
    history = study.read_history(study.cases[0])
    before = get_omega(history)[history["time"] == ON][0]
    share, ratio, stretch = 0.5, 1, 2
    ground = np.sqrt(before**2 - (1 - share) * (1 + ratio) * 4 / stretch**2)
    return (f"final {show(final, 5)}; {before:.4f}, ground network alone "
            f"{ground:.3f}",
            {"the number of networks": np.ptp(final) < 1e-3 * final[0],
             "only the ground network": bool(ground > 0.95 * before)})


@CLAIMS.add("3.12", "the rate of the voltage changes only the time",
            "final Omega within 0.01 %, times to 1 % differ")
def rate_changes_time(results):
    study = results["resonator_12"]
    final = [case["final frequency"] / paper.FREQUENCY for case in study.cases]
    times = [find_arrival(study.read_history(case)) for case in study.cases]
    return (f"Omega {show(final, 6)}; {', '.join(f'{t:.0f} s' for t in times)}",
            {"all": np.ptp(final) < 1e-4 * final[0] and rises(times)})


def get_gaps(study):
    rates, failure = study.get_curve("rate", "failure voltage")
    return rates, failure / study.get_curve("rate", "hold limit")[1] - 1


@CLAIMS.add("3.13", "V_f* = V_p* below a rate of about 0.01, V_f* > V_p* above",
            "V_f*/V_p* - 1 below 1e-6 up to 0.01, above 1e-4 from 0.02 on")
def limits_part(results):
    rates, gaps = get_gaps(results["resonator_13"])
    slow, fast = gaps[rates < 0.0101], gaps[rates > 0.0199]
    return (f"up to 0.01: below {np.max(slow):.0e}; from "
            f"{rates[rates > 0.0199][0]:.3f} on: {show(fast, 2)}",
            {"all": bool(np.max(slow) < 1e-6 and np.min(fast) > 1e-4)})


@CLAIMS.add("3.13", "V_p* is the limit of operation",
            "no ramp fails below it (to 1e-7)")
def hold_is_limit(results):
    study = results["resonator_13"]
    rates, gaps = get_gaps(study)
    holds = study.get_curve("rate", "hold limit")[1] / paper.VOLTAGE
    text = ", ".join(f"{holds[np.argmin(np.abs(np.log(rates / rate)))]:.5f} "
                     f"at {rate:g}" for rate in (1e-4, 0.00178, 0.01, 10))
    return text, {"all": bool(np.min(gaps) > -1e-7)}


@CLAIMS.add("3.14", "the ranges of tuning depend on the rate",
            "the largest shift varies by more than 1 % over the rates")
def ranges_depend(results):
    study = results["resonator_14"]
    case = study.cases[0]
    rest, lowest = case["frequency without voltage"], case["lowest frequency"]
    top = (study.get_curve("rate", "frequency at hold limit")[1] - rest)
    top /= paper.FREQUENCY
    history = study.read_history(case)
    where = history["voltage"][np.argmin(history["natural frequency"])]
    return (f"largest shift {top[0]:.3f} (r=1e-4), least of all {top.min():.3f}, "
            f"{top[-1]:.3f} (r=10); smallest "
            f"{(lowest - rest) / paper.FREQUENCY:.4f} at "
            f"V*={where / paper.VOLTAGE:.4f}",
            {"all": bool(np.ptp(top) > 0.01 * top.min())})


def get_extremes(results):
    """{k: (lowest, highest shift)} of the states that survive."""
    study = results["resonator_15"]
    extremes = {}
    for ratio in study.get_values("ratio"):
        shifts = [case["frequency"] - case["frequency without voltage"]
                  for case in study.select(ratio=ratio, status="completed")]
        extremes[ratio] = np.array([min(shifts), max(shifts)])
        extremes[ratio] /= paper.get_frequency(ratio)
    return extremes


@CLAIMS.add("3.15", "k = 2 shifts up to 2.2 and down to -0.2 (J_lim is fitted to "
            "this)", "the extremes round to these")
def extremes_of_two(results):
    lowest, highest = get_extremes(results)[2.0]
    return (f"{highest:.3f}, {lowest:.3f}",
            {"all": round(highest, 1) == 2.2 and round(lowest, 1) == -0.2})


@CLAIMS.add("3.15", "larger k raises the largest shift", "it rises over k")
def ratio_raises(results):
    highest = [pair[1] for pair in get_extremes(results).values()]
    return show(highest, 4), {"all": rises(highest)}


@CLAIMS.add("3.15", "k has a minor effect on the smallest shift",
            "from one k to the next it changes by less than a quarter of the "
            "change of the largest")
def ratio_is_minor(results):
    extremes = get_extremes(results)
    ratios = list(extremes)
    outcomes = {}
    for first, second in zip(ratios, ratios[1:]):
        low, high = np.abs(extremes[second] - extremes[first])
        outcomes[f"k = {first:g} to {second:g}"] = bool(low < high / 4)
    return show([pair[0] for pair in extremes.values()]), outcomes


@CLAIMS.add("3.15", "easier to tune up than down",
            "the largest shift exceeds the smallest in magnitude")
def up_is_easier(results):
    extremes = get_extremes(results)
    return ("; ".join(f"k={ratio:g}: {low:+.2f} {high:+.2f}"
                      for ratio, (low, high) in extremes.items()),
            {f"k = {ratio:g}": bool(high > -low)
             for ratio, (low, high) in extremes.items()})


@CLAIMS.add("3.2 to 3.9", "electrical breakdown is one of the failures",
            "a run ends with it")
def breakdown_occurs(results):
    cases = [(results[f"resonator_0{i}"], case) for i in range(2, 10)
             for case in results[f"resonator_0{i}"].cases]
    broken = sum("breakdown" in case["reason"] for _, case in cases)
    # True field over its unit, V* lambda_1A lambda_2 with lambda_2 = 4.
    largest = max(4 * case["voltage at failure"] / paper.VOLTAGE *
                  case["stretch at failure"] for _, case in cases)
    return (f"{broken} of {len(cases)} runs; largest V* lambda_1 lambda_2 "
            f"{largest:.2f} of 5", {"all": broken > 0})
