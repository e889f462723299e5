"""How a claim is written down, and the measures that the rules use."""

from dataclasses import dataclass
from typing import Callable

import numpy as np


@dataclass
class Claim:
    """compute(results) gives the numbers as text and {condition: met}."""
    figure: str
    text: str
    rule: str
    compute: Callable


class Collection(list):
    """Takes functions as the claims of a paper, in order."""

    def add(self, figure, text, rule):
        def keep(compute):
            self.append(Claim(figure, text, rule, compute))
            return compute
        return keep


def rises(values):
    return bool(np.all(np.diff(values) > 0))


def falls(values):
    return bool(np.all(np.diff(values) < 0))


def falls_where_reached(times):
    """Whether times fall, where those that are never reached stand first."""
    times = np.asarray(times)
    reached = np.flatnonzero(np.isfinite(times))
    return bool(len(reached) > 1 and reached[-1] == len(times) - 1 and
                np.all(np.diff(reached) == 1) and falls(times[reached]))


def show(values, digits=3):
    """Numbers side by side."""
    return " ".join("never" if np.isinf(value) else f"{value:.{digits}g}"
                    for value in values)


def find_settling_time(times, values, rest, share=0.05):
    """From when on the values stay within a share of the rest value; infinite if
    they do not within the last hundredth of the time."""
    outside = np.flatnonzero(np.abs(values - rest) > share * abs(rest))
    if not len(outside):
        return 0.0
    last = times[outside[-1]]
    return last if last < 0.99 * times[-1] else np.inf


def get_range(values):
    return float(np.max(values) - np.min(values))


def get_window(times, values, begin, end):
    return values[(times >= begin) & (times <= end)]


def count_turns(values, least):
    """Interior extremes between which the values move by more than `least`."""
    turns, direction, extreme = 0, 0, values[0]
    for value in values[1:]:
        step = value - extreme
        if direction == 0:
            if abs(step) > least:
                direction, extreme = np.sign(step), value
        elif step * direction > 0:
            extreme = value
        elif abs(step) > least:
            turns, direction, extreme = turns + 1, -direction, value
    return turns
