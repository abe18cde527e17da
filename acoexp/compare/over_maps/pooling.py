"""Effects over maps: one on each map, and what they say of maps like these.

The pooled effect is the mean over maps with Student's interval, a random-effects estimate of equal weights: what
maps vary by holds both the differences between them and the noise of their seeds. Inverse variances are no weights
here: a map on which one configuration always wins, or all trials tie, has an estimated variance of nothing, and
would outweigh all others. The prediction interval (Higgins, Thompson, Spiegelhalter 2009) tells where the effect
on one more such map is to be expected.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used
from numpy.typing import NDArray

from acoexp.compare.sample import Row, Sample
from acoexp.compare.statistics import LEVEL, Estimate, a12, superiority


class Pooled(NamedTuple):
    """A mean effect over maps with its interval, and the interval of one more map's."""

    mean: Estimate
    next_low: float
    next_high: float


def pooled(effects: NDArray[np.float64]) -> Pooled:
    """Return what A12 of two or more maps, float[maps], say together; intervals end at 0 and 1."""
    n, mean, deviation = effects.size, float(effects.mean()), float(effects.std(ddof=1))
    t = float(scipy.stats.t.ppf((1.0 + LEVEL) / 2.0, n - 1))
    mean_reach, next_reach = t * deviation / n**0.5, t * deviation * (1.0 + 1.0 / n) ** 0.5
    ends = [float(np.clip(mean + reach, 0.0, 1.0)) for reach in (-mean_reach, mean_reach, -next_reach, next_reach)]
    return Pooled(Estimate(mean, ends[0], ends[1]), ends[2], ends[3])


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
