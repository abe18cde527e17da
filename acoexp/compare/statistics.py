"""Statistics of trials: intervals, effect sizes and tests that fit paired, censored measurements.

Trials of two configurations with one seed share random numbers, so tests are paired and resampling keeps the
pairs. A trial that misses the optimum is censored: it ranks behind all that found it. All intervals are at 95 %.

Sources: Vargha, Delaney 2000 (A12); Wilson 1927; McNemar 1947; Holm 1979; Auger, Hansen 2005 (expected running
time of restarts).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used: it is a fifth of what a command costs to start
from numpy.typing import NDArray

Values = NDArray[np.float64]
Flags = NDArray[np.bool_]

LEVEL = 0.95
SIGNIFICANCE = 0.05
RESAMPLES = 2000
_BATCH = 100  # resamples in memory at a time


class Estimate(NamedTuple):
    """A number with its interval."""

    value: float
    low: float
    high: float


def mean_and_deviation(values: Values) -> tuple[float, float]:
    """Return the mean and the sample's standard deviation of the values that are not nan; nan if too few."""
    known = values[~np.isnan(values)]
    mean = float(known.mean()) if known.size else np.nan
    return mean, float(known.std(ddof=1)) if known.size > 1 else np.nan


def success_rate(found: Flags) -> Estimate:
    """Return the share of successes with Wilson's interval."""
    test = scipy.stats.binomtest(int(found.sum()), found.size)
    interval = test.proportion_ci(LEVEL, method="wilson")
    return Estimate(float(test.statistic), float(interval.low), float(interval.high))


def expected_running_time(cycles: Values, found: Flags) -> Estimate:
    """Return the cycles spent by all trials per success, with its bootstrap interval; inf if there is none.

    Args:
        cycles: Cycles that each trial spent until it found the optimum, or else until its end, float[n].
        found: Whether it found the optimum, bool[n].
    """

    if not found.any():
        return Estimate(np.inf, np.nan, np.inf)

    def successes_per_cycle(trials: NDArray[Any], axis: int = -1) -> Any:
        return found[trials].sum(axis=axis) / cycles[trials].sum(axis=axis)

    rate = _bootstrap(successes_per_cycle, found.size)  # finite where the time per success is not
    return Estimate(*(1.0 / r if r > 0.0 else np.inf for r in (rate.value, rate.high, rate.low)))


def a12(a: Values, b: Values) -> Any:
    """Return the probability that a value of ``a`` is smaller than one of ``b``, ties counted half.

    Args:
        a: Measurements of which smaller ones are better, float[..., n].
        b: Those of the other configuration, of the same shape.
    """
    n = a.shape[-1]
    ranks = scipy.stats.rankdata(np.concatenate([a, b], axis=-1), axis=-1)
    return (ranks[..., n:].mean(axis=-1) - (n + 1) / 2) / n


def superiority(a: Values, b: Values) -> Estimate:
    """Return A12 with its interval; see :func:`a12`.

    Args:
        a: Measurements of which smaller ones are better, float[n].
        b: Those of the other configuration with the same seeds, float[n]; pairs are resampled together.
    """
    return _bootstrap(lambda trials, axis=-1: a12(a[trials], b[trials]), a.size)


def odds_ratio(a: Flags, b: Flags) -> Estimate:
    """Return the odds ratio of success from the pairs in which one alone succeeded, with its exact interval.

    It is the conditional estimate that belongs to McNemar's test; nan, 0 to inf, without such pairs.
    """
    only_a, only_b = int((a & ~b).sum()), int((b & ~a).sum())
    if only_a + only_b == 0:
        return Estimate(np.nan, 0.0, np.inf)
    test = scipy.stats.binomtest(only_a, only_a + only_b)
    interval = test.proportion_ci(LEVEL, method="exact")
    shares = (float(test.statistic), float(interval.low), float(interval.high))
    return Estimate(*(share / (1.0 - share) if share < 1.0 else np.inf for share in shares))


def sign_test(a: Values | Flags, b: Values | Flags) -> float:
    """Return the two-sided p of the exact sign test: a fair coin among the pairs that differ; 1 without any.

    It asks what A12 measures, whether one wins more often, and minds neither censoring nor skewed or bimodal
    differences, as a signed-rank test would. With flags it is McNemar's exact test.
    """
    wins, losses = int((a < b).sum()), int((a > b).sum())
    return float(scipy.stats.binomtest(wins, wins + losses).pvalue) if wins + losses else 1.0


def holm(p_values: Sequence[float]) -> list[float]:
    """Return the p values of a family as Holm's step-down procedure corrects them, in the same order."""
    p = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(p, kind="stable")
    stepped = np.maximum.accumulate(p[order] * np.arange(p.size, 0, -1))
    corrected = np.empty_like(p)
    corrected[order] = np.minimum(stepped, 1.0)
    return [float(value) for value in corrected]


def interval_of_means(values: Values) -> Values:
    """Return the bootstrap intervals of the columns' means, float[2, columns], rows drawn together.

    Args:
        values: float[rows, columns], a row for each map.
    """
    rows = len(values)
    drawn = np.random.default_rng(0).multinomial(rows, np.full(rows, 1.0 / rows), size=RESAMPLES) / rows
    tail = (1.0 - LEVEL) / 2.0
    ends: Values = np.quantile(drawn @ values, (tail, 1.0 - tail), axis=0)
    return ends


def _bootstrap(statistic: Callable[..., Any], n: int) -> Estimate:
    """Return a statistic of the trials 0..n-1 with its percentile interval, the same at every call."""
    trials = np.arange(n)
    interval = scipy.stats.bootstrap(
        (trials,),
        statistic,
        n_resamples=RESAMPLES,
        batch=_BATCH,
        vectorized=True,
        confidence_level=LEVEL,
        method="percentile",
        random_state=np.random.default_rng(0),
    ).confidence_interval
    return Estimate(float(statistic(trials)), float(interval.low), float(interval.high))
