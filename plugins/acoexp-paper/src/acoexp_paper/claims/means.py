"""Means of ten trials, which the paper prints: where they fall if its trials were like ours.

Each is held against the distribution of such means and not against the interval of ours, which many more trials
make narrow. Over several maps the map is drawn too, each as likely as another.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.statistics import LEVEL, Estimate, Values
from acoexp_paper.published.tables import TRIALS

_RESAMPLES = 5000


def mean(values: Values) -> float:
    """Return the mean of the values that are defined; nan without any."""
    defined = values[~np.isnan(values)]
    return float(defined.mean()) if defined.size else np.nan


def mean_of_maps(maps: Sequence[Values]) -> float:
    """Return the mean over maps, each of which counts once, of the means that are defined; nan without any."""
    return mean(np.array([mean(values) for values in maps]))


def mean_of_ten(maps: Sequence[Values], scale: float = 1) -> Estimate:
    """Return the mean over maps, and the interval of the mean of ten trials on one of the maps.

    Args:
        maps: Values on each map, float[n]; one map for no choice.
        scale: A factor for all three numbers.
    """
    means = _means_of_ten(maps)
    tail = 100 * (1 - LEVEL) / 2
    defined = means[~np.isnan(means)]
    low, high = np.percentile(defined, (tail, 100 - tail)) if defined.size else (np.nan, np.nan)
    return Estimate(scale * mean_of_maps(maps), scale * float(low), scale * float(high))


def rarity(maps: Sequence[Values], printed: float) -> float:
    """Return the share of means of ten trials that lie as far from the mean of all as the printed one, at least.

    Args:
        maps: Values on each map, float[n]; nan where there is none.
        printed: The printed mean.
    """
    centre = mean_of_maps(maps)
    if np.isnan(centre):
        return 0.0
    off = np.abs(np.nan_to_num(_means_of_ten(maps), nan=np.inf) - centre).round(9)
    as_far = int((off >= round(abs(printed - centre), 9)).sum())
    return (as_far + 1) / (_RESAMPLES + 1)


def _means_of_ten(maps: Sequence[Values]) -> Values:
    """Return many means of ten trials, each of trials on one of the maps, which is drawn too, float[resamples].

    What is nan is left out of a mean, and a mean of nothing is nan.
    """
    values = maps[0][_places(maps[0].size)]
    if len(maps) > 1:
        on = np.random.default_rng(0).integers(len(maps), size=_RESAMPLES)
        for place, of_map in enumerate(maps):
            values[on == place] = of_map[_places(of_map.size)[on == place]]
    defined = ~np.isnan(values)
    if defined.all():
        return np.asarray(values.mean(axis=1))
    total, of = np.where(defined, values, 0.0).sum(axis=1), defined.sum(axis=1)
    return np.where(of > 0, total / np.maximum(of, 1), np.nan)


@cache
def _places(trials: int) -> NDArray[np.int64]:
    """Return ten of so many trials for each mean, int[resamples, 10]."""
    return np.random.default_rng(1).integers(trials, size=(_RESAMPLES, TRIALS))
