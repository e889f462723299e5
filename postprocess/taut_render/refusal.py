"""Wrong input: told in one line, exit code 2."""

import difflib


class Refusal(Exception):
    """The message says what is wrong and what to do instead."""


def suggest(word, known):
    """", did you mean 'x'?" or nothing."""
    near = difflib.get_close_matches(word, known, n=1, cutoff=0.5)
    return f", did you mean '{near[0]}'?" if near else ""
