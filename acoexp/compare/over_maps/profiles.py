"""Performance profiles (Dolan, More 2002): the share of maps on which one is within a factor of the best."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.over_maps.values import Matrix


def ratios_to_best(values: Matrix) -> Matrix:
    """Return each value over the map's smallest, at least 1; inf where a configuration has none, or nobody has.

    Args:
        values: Above 0, inf for the worst.
    """
    best = values.min(axis=1, keepdims=True)
    reached = np.isfinite(values)
    ratios = np.full(values.shape, np.inf)
    np.divide(values, best, out=ratios, where=reached)
    return ratios


def profile(ratios: NDArray[np.float64], factors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the share of maps on which one configuration's ratio is at most each factor.

    Args:
        ratios: float[maps].
        factors: float[factors].
    """
    shares = np.searchsorted(np.sort(ratios), factors, side="right") / ratios.size
    return shares.astype(np.float64)
