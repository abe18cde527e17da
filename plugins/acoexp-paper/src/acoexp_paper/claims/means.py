"""Means of ten trials, which the paper prints: where they fall if its trials were like ours.

Each is held against the distribution of such means and not against the interval of ours, which many more trials
make narrow. Over an ensemble the map is drawn too.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy  # scipy.stats is imported when first used

from acoexp.compare.statistics import LEVEL, Estimate, Values
from acoexp_paper.published.tables import TRIALS

_RESAMPLES = 10_000
_RESAMPLES_OF_TEST = 9999


def mean(values: Values) -> float:
    """Return the mean of the values that are defined; nan without any."""
    defined = values[~np.isnan(values)]
    return float(defined.mean()) if defined.size else np.nan


def mean_of_ten(maps: Sequence[Values], scale: float = 1) -> Estimate:
    """Return the mean of all values, and the interval of the mean of ten trials on one of the maps.

    Args:
        maps: Values on each map, float[n] each of one size; one map for no choice.
        scale: A factor for all three numbers.
    """
    values = np.array(maps)
    means = _means_of_ten(values, _RESAMPLES)
    tail = 100 * (1 - LEVEL) / 2
    defined = means[~np.isnan(means)]
    low, high = np.percentile(defined, (tail, 100 - tail)) if defined.size else (np.nan, np.nan)
    return Estimate(scale * mean(values.ravel()), scale * float(low), scale * float(high))


def rarity(maps: Sequence[Values], printed: float) -> float:
    """Return the share of means of ten trials that lie as far from the mean of all as the printed one, at least.

    Args:
        maps: Values on each map, float[n] each of one size; nan where there is none.
        printed: The printed mean.
    """
    values = np.array(maps)
    if np.isnan(values).all():
        return 0.0
    centre = float(np.nanmean(values))

    def means(size: tuple[int, ...]) -> Values:
        return _means_of_ten(values, size[0])[:, None]

    def distance(mean: Values, axis: int) -> Values:
        off = np.abs(np.nan_to_num(mean, nan=np.inf) - centre).round(9)
        return np.asarray(off.max(axis=axis), dtype=np.float64)

    test = scipy.stats.monte_carlo_test(
        [printed], means, distance, n_resamples=_RESAMPLES_OF_TEST, alternative="greater"
    )
    return float(test.pvalue)


def _means_of_ten(values: Values, count: int) -> Values:
    """Return so many means of ten trials drawn from one of the maps, which is drawn too.

    Args:
        values: float[maps, n]; what is nan is left out of a mean, and a mean of nothing is nan.
        count: How many.
    """
    random = np.random.default_rng(0)
    on = random.integers(len(values), size=(count, 1))
    drawn = values[on, random.integers(values.shape[1], size=(count, TRIALS))]
    defined = ~np.isnan(drawn)
    total, of = np.where(defined, drawn, 0.0).sum(axis=1), defined.sum(axis=1)
    return np.where(of > 0, total / np.maximum(of, 1), np.nan)
