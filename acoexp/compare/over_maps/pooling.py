"""Effects over maps: one on each map, and what they say of maps like these.

The pooled effect is that of a random-effects model (DerSimonian, Laird 1986) with equal weights: the mean over
maps with Student's interval, which is Hartung and Knapp's (2001) for such weights. What maps vary by holds both
the differences between them and the noise of their seeds; where that noise is known, it is taken off (Hedges
1983). Inverse variances are no weights here: a map on which one configuration always wins, or all trials tie, has
an estimated variance of nothing, and would outweigh all others. The prediction interval (Higgins, Thompson,
Spiegelhalter 2009) tells where the effect on one more such map is to be expected.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used
from numpy.typing import NDArray

from acoexp.compare.sample import Row, Sample
from acoexp.compare.statistics import LEVEL, Estimate, a12, superiority


class Pooled(NamedTuple):
    """A mean effect over maps with its interval, and the interval of one more map's.

    Attributes:
        mean: The mean, and its interval.
        next_low, next_high: The prediction interval.
        spread: Standard deviation of the effect between maps.
        error: Standard error of the mean.
        maps: How many maps there are; with weights, how many of equal weight would say as much (Kish 1965).
    """

    mean: Estimate
    next_low: float
    next_high: float
    spread: float
    error: float
    maps: float


def pooled(
    effects: NDArray[np.float64],
    noise: NDArray[np.float64] | float = 0.0,
    weights: NDArray[np.float64] | None = None,
    bounds: tuple[float, float] = (0.0, 1.0),
) -> Pooled:
    """Return what effects of two or more maps, float[maps], say together.

    Args:
        effects: A12, unless the bounds say otherwise.
        noise: Variance of each effect over seeds, float[maps]; without it, it counts as a difference of the maps.
        weights: Of the maps, float[maps], of which none alone has all the weight; equal if not given.
        bounds: Between which effects can lie; intervals end there.
    """
    w = np.full(effects.size, 1.0 / effects.size) if weights is None else weights / weights.sum()
    of_seeds = np.broadcast_to(noise, w.shape)
    mean, squares = float(w @ effects), float(w @ w)
    deviation = float(w @ (effects - mean) ** 2) - float((w * (1.0 - w)) @ of_seeds)
    between = max(0.0, deviation / (1.0 - squares))
    error = float((w * w) @ (between + of_seeds)) ** 0.5
    t = float(scipy.stats.t.ppf((1.0 + LEVEL) / 2.0, 1.0 / squares - 1.0))
    mean_reach, next_reach = t * error, t * (between + error**2) ** 0.5
    ends = [float(np.clip(mean + reach, *bounds)) for reach in (-mean_reach, mean_reach, -next_reach, next_reach)]
    interval = Estimate(mean, ends[0], ends[1])
    return Pooled(interval, ends[2], ends[3], between**0.5, error, 1.0 / squares)


def effect(a: Sample, b: Sample) -> float:
    """Return A12 of the best lengths on one map: how often a trial of ``a`` has the shorter path than one of
    ``b``.

    Ties count half, and a trial whose ants were all lost is behind every other.
    """
    return float(a12(a.gaps[:, -1], b.gaps[:, -1]))


def effect_row(a: Sample, b: Sample) -> Row:
    """Return that with its interval over seeds, which says how well it is known on this map."""
    estimate = superiority(a.gaps[:, -1], b.gaps[:, -1])
    names = {"map": a.map, "a": a.configuration, "b": b.configuration}
    return {**names, "a12": estimate.value, "low": estimate.low, "high": estimate.high}
