"""Samples: the trials of one algorithm on one map, and what the paper and its claims ask of each of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from acoexp.compare.sample import Sample
from acoexp.compare.statistics import Flags, Values
from acoexp.trial.features import x2_last
from acoexp_paper.trials.concentration import CYCLES, ENTROPY, ON_SHORTEST

Samples = Mapping[str, Sample]
"""By algorithm, on one map; the trials of all have the same seeds."""

X2_LAST = "x2_last"
"""x2 in its other reading, for which the paper's column x2 stands too."""

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


def values_of(sample: Sample, column: str) -> Values:
    """Return what a column of the paper's, or ``x2_last``, says of each trial, float[n]; nan for nothing."""
    if column == X2_LAST:
        values = np.array([x2_last(curve) for curve in sample.curves], dtype=np.float64)
        return np.where(values > 0, values, np.nan)
    if column == "n_c":
        return sample.found.astype(np.float64)
    if column == "l_bar":
        return sample.features["l2"]
    if column == "n_bar":
        return np.where(sample.found, sample.features["x1"], np.nan)
    return sample.features[column]


def first_trials(sample: Sample, count: int) -> Sample:
    """Return the first so many trials of a sample."""
    features = {name: values[:count] for name, values in sample.features.items()}
    return replace(sample, found=sample.found[:count], features=features, curves=sample.curves[:count])


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
    "pheromone elsewhere": Measure(
        lambda s: -s.features[ON_SHORTEST],
        f"has more of its pheromone on shortest paths after {CYCLES[-1]} cycles",
    ),
    "entropy": Measure(
        lambda s: s.features[ENTROPY], f"has its pheromone more concentrated after {CYCLES[-1]} cycles"
    ),
}

EVENTS = {
    "found": Event(lambda s: s.found, "finds the optimum"),
    "converged": Event(lambda s: s.features["l2"] == s.optimum, "converges to the optimum"),
    "stuck": Event(lambda s: s.features["l2"] != s.optimum, "converges to a local optimum"),
    "steady": Event(_steady, "has x1 = x2 = x3"),
}
