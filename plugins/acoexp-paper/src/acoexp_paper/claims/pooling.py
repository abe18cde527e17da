"""What one map says of an effect, and what all maps say together: a random-effects model, one map or many.

The model is :func:`acoexp.compare.over_maps.pooling.pooled`. Whether maps differ by more than their seeds do is
asked of the variance over maps, in units of that over seeds: under equal maps it is a quadratic form of normal
variables, whose distribution Satterthwaite's (1946) chi-squared approximates.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used

from acoexp.compare.over_maps.pooling import pooled
from acoexp.compare.statistics import LEVEL, Estimate, Values

DIFFERENT = 0.01
"""Level at which maps are taken to differ, so that equal ones hardly ever do, however many claims there are."""


class Effect(NamedTuple):
    """An effect on one map.

    Attributes:
        value: The effect.
        noise: Variance of the value over seeds.
    """

    value: float
    noise: float


class Over(NamedTuple):
    """An effect over maps.

    Attributes:
        mean: Its mean with its interval.
        next: The prediction interval: where the effect on one more such map lies; None with a single map.
        spread: Standard deviation between maps, without the seeds' noise.
        error: Standard error of the mean.
        maps: How many maps; with weights, how many of equal weight would say as much.
        p_between: p that the maps are equal; 1 with a single one.
    """

    mean: Estimate
    next: tuple[float, float] | None
    spread: float
    error: float
    maps: float
    p_between: float

    @property
    def differ(self) -> bool:
        """Whether the maps differ by more than their seeds do."""
        return self.p_between < DIFFERENT

    def p_against(self, neutral: float) -> float:
        """Return the two-sided p of the mean being this."""
        off = abs(self.mean.value - neutral)
        if off == 0.0:
            return 1.0
        errors = off / self.error if self.error > 0.0 else np.inf
        degrees = np.inf if self.next is None else self.maps - 1.0  # seeds are many
        return float(2.0 * scipy.stats.t.sf(errors, degrees))


def effect_of(influences: Values, width: float) -> Effect:
    """Return the mean of what each pair of trials says, and its variance.

    So that a map on which all pairs say the same has a variance too, one that says the most and one that says the
    least are added to it (after Agresti and Min 2005).

    Args:
        influences: What each says, float[n].
        width: How far apart two can lie.
    """
    n, mean = influences.size, float(influences.mean())
    squares = float(((influences - mean) ** 2).sum()) + width**2 / 2.0
    return Effect(mean, squares / (n * (n - 1)))


def over(effects: Sequence[Effect], bounds: tuple[float, float], weights: Values | None = None) -> Over:
    """Return what the effects of one or more maps say together.

    Args:
        effects: One on each map.
        bounds: Between which they can lie.
        weights: The maps', of which none alone has all of it; equal if not given.
    """
    values, noise = (np.array(column) for column in zip(*effects, strict=True))
    if values.size == 1:
        return _of_one(effects[0], bounds)
    found = pooled(values, noise, weights, bounds)
    ends = found.next_low, found.next_high
    return Over(found.mean, ends, found.spread, found.error, found.maps, _p_between(values, noise))


def _of_one(effect: Effect, bounds: tuple[float, float]) -> Over:
    value, error = effect.value, effect.noise**0.5
    reach = float(scipy.stats.norm.ppf((1.0 + LEVEL) / 2.0)) * error
    low, high = (float(np.clip(value + end, *bounds)) for end in (-reach, reach))
    return Over(Estimate(value, low, high), None, np.nan, error, 1.0, 1.0)


def _p_between(values: Values, noise: Values) -> float:
    squares = float(((values - values.mean()) ** 2).sum())
    k, total, of_squares = values.size, float(noise.sum()), float((noise**2).sum())
    expected = total * (1.0 - 1.0 / k)
    if expected == 0.0:
        return 1.0 if squares == 0.0 else 0.0
    variance = 2.0 * (of_squares * (1.0 - 2.0 / k) + (total / k) ** 2)
    return float(scipy.stats.chi2.sf(squares / (variance / (2.0 * expected)), 2.0 * expected**2 / variance))
