"""What claims are about: values of a trial that may be smaller, and events that may happen in it."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from acoexp.report.measures import Sample
from acoexp.report.statistics import Flags, Values

_BEHIND_ALL = 1e9


class Measure(NamedTuple):
    """A value of each trial; one without a value, or that missed the optimum, ranks behind all others.

    Attributes:
        values: float[n] of a sample.
        smaller: What an algorithm does that has smaller values, before "than" and another.
    """

    values: Callable[[Sample], Values]
    smaller: str


class Event(NamedTuple):
    """Something that happens in a trial, or not.

    Attributes:
        flags: bool[n] of a sample.
        words: What the algorithm does in such a trial.
    """

    flags: Callable[[Sample], Flags]
    words: str


def _waiting(sample: Sample) -> Values:
    return _ranked(sample.features["x2"] - sample.features["x1"])


def _ranked(values: Values) -> Values:
    return np.nan_to_num(values, nan=_BEHIND_ALL)


def _steady(sample: Sample) -> Flags:
    x = sample.features
    steady: Flags = (x["x1"] == x["x2"]) & (x["x2"] == x["x3"])
    return steady


MEASURES = {
    "hitting time": Measure(lambda s: s.hitting_time(s.iterations + 1), "finds the optimum in fewer iterations"),
    "lost ants": Measure(lambda s: s.features["lost_ants"], "loses fewer ants"),
    "l2": Measure(lambda s: _ranked(s.features["l2"]), "converges to shorter paths"),
    "x2 - x1": Measure(_waiting, "has a smaller x2 - x1"),
    "x3": Measure(lambda s: _ranked(s.features["x3"]), "settles (x3) earlier"),
}

EVENTS = {
    "found": Event(lambda s: s.found, "finds the optimum"),
    "converged": Event(lambda s: s.features["l2"] == s.optimum, "converges to the optimum"),
    "stuck": Event(lambda s: s.features["l2"] != s.optimum, "converges to a local optimum"),
    "steady": Event(_steady, "has x1 = x2 = x3"),
}
