"""Which share of an outcome's variance each key explains, and which the seeds alone.

A trial's outcome is f(x) + e: what its keys x come to on average over seeds, and the chance of its own seed. With
some trials at each point, each with a seed of its own, the variance of e is the mean variance at a point, and what
it adds to the variance of the points' means is taken off again; all shares are of the variance of *one* trial.

Sources: Sobol 1993; Saltelli et al. 2010, Table 2 (b), (f), the estimators of scipy.stats.sobol_indices, which
has no place for seeds. All intervals are at 95 %, by a bootstrap over the points.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LEVEL = 0.95
RESAMPLES = 1000


class Share(NamedTuple):
    """A share of a variance with its interval; an estimate, which may lie a little below 0."""

    value: float
    low: float
    high: float


class Shares(NamedTuple):
    """How the variance of one trial's outcome is made up.

    Attributes:
        alone: First-order index of each key: what it explains whatever the others are.
        total: Total index of each key: that, and what it explains together with others.
        together: What only several keys together explain.
        seeds: What no key explains: the chance of a trial's seed.
        first: Share of the bootstrap's resamples in which each key's total is the largest, float[k].
    """

    alone: list[Share]
    total: list[Share]
    together: Share
    seeds: Share
    first: Array


def shares_of(outcome: Array) -> Shares | None:
    """Return how the variance of an outcome is made up; None if it has none.

    Args:
        outcome: float[k + 2, points, trials]: at the points of the samples A, B, and A with each of k columns of
            B, of each trial there. A power of two of points, and two trials or more.
    """
    k, points = len(outcome) - 2, outcome.shape[1]
    value = _decomposed(outcome)
    if value is None:
        return None
    random = np.random.default_rng(0)
    resampled = [_decomposed(outcome[:, random.integers(points, size=points)]) for _ in range(RESAMPLES)]
    known = np.array([one for one in resampled if one is not None])
    low, high = np.quantile(known, ((1.0 - LEVEL) / 2.0, (1.0 + LEVEL) / 2.0), axis=0)
    parts = [Share(*map(float, numbers)) for numbers in zip(value, low, high, strict=True)]
    leaders = known[:, k : 2 * k].argmax(axis=1)
    first = np.bincount(leaders, minlength=k) / len(leaders)
    return Shares(parts[:k], parts[k : 2 * k], parts[2 * k], parts[2 * k + 1], first)


def _decomposed(outcome: Array) -> Array | None:
    """Return the first-order indices, the total ones, what keys explain together, and the seeds' share.

    As float[2 k + 2]; None without any variance.
    """
    trials = outcome.shape[2]
    means, at_points = outcome.mean(axis=2), outcome.var(axis=2, ddof=1).mean(axis=1)
    of_means, of_seeds = float(means[:2].var()), float(at_points[:2].mean())
    whole = of_means + of_seeds * (1.0 - 1.0 / trials)
    if whole <= 0.0:
        return None
    a, b, mixed = (part - means[:2].mean() for part in (means[0], means[1], means[2:]))
    alone = (b * (mixed - a)).mean(axis=1)
    total = 0.5 * ((a - mixed) ** 2).mean(axis=1) - (at_points[0] + at_points[2:]) / (2 * trials)
    together = of_means - of_seeds / trials - alone.sum()
    parts: Array = np.array([*alone, *total, together, of_seeds]) / whole
    return parts
