"""The two designs: one key at a time about the command line's configuration, and all keys at once.

The second is Saltelli's (2010, Table 2): two samples A and B of the keys' space, which scrambled Sobol points fill
evenly, and for each key A with that key's column of B.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used: it is a fifth of what a command costs to start

from acoexp.sensitivity.span import Factor

LEVELS = 9
"""Values of a key that its curve goes through, beside the command line's own."""

Values = dict[str, float]


class Level(NamedTuple):
    """A point of a curve.

    Attributes:
        key: Which key's curve.
        value: That key's value, all others having the command line's.
    """

    key: str
    value: float


def levels(factors: Sequence[Factor]) -> list[Level]:
    """Return the points of all curves, key by key in ascending order; the command line's values among them."""
    return [Level(factor.key, value) for factor in factors for value in _through(factor)]


def _through(factor: Factor) -> list[float]:
    values = factor.span.levels(LEVELS)
    if math.isnan(factor.value):
        return values
    others = [value for value in values if not math.isclose(value, factor.value)]
    return sorted([*others, factor.value])


def saltelli(factors: Sequence[Factor], points: int) -> list[Values]:
    """Return the configurations of the samples A and B and of A with each key's column of B, ``points`` of each.

    Args:
        factors: The keys, k of them.
        points: A power of two.

    Returns:
        (k + 2) * points of them, sample by sample; the same at every call.
    """
    k = len(factors)
    both = scipy.stats.qmc.Sobol(2 * k, seed=np.random.default_rng(0)).random(points)
    a, b = both[:, :k], both[:, k:]
    mixed = [np.where(np.arange(k) == column, b, a) for column in range(k)]
    return [
        {factor.key: factor.span.at(share) for factor, share in zip(factors, row, strict=True)}
        for sample in (a, b, *mixed)
        for row in sample
    ]
