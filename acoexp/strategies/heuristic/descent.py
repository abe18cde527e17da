"""Descent: preferring moves that lead down a field of distances, whatever these are taken to be."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from acoexp.strategies.heuristic.targets import at_targets


def descent(distance: NDArray[np.float64], strength: float) -> NDArray[np.float64]:
    """Return exp(strength * (d(cell) - d(target))) for each move, float64[rows, cols, 8].

    Args:
        distance: float64[rows, cols], in cells; inf where it is not known.
        strength: How much one cell of progress counts.

    It is 1 where the distance of either cell is not known, and where a move leads out of the map.
    """
    here, factor = distance[..., None], at_targets(np.pad(distance, 1, constant_values=np.inf))
    known = np.isfinite(here) & np.isfinite(factor)
    np.subtract(here, factor, where=known, out=factor)
    factor[~known] = 0.0
    factor *= strength
    return np.exp(factor, out=factor)
