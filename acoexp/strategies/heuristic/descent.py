"""Descent: preferring moves that lead down a field of distances, whatever these are taken to be."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.moves import DIRECTIONS


def descent(distance: NDArray[np.float64], strength: float) -> NDArray[np.float64]:
    """Return exp(strength * (d(cell) - d(target))) for each move, float64[rows, cols, 8].

    Args:
        distance: float64[rows, cols], in cells; inf where it is not known.
        strength: How much one cell of progress counts.

    It is 1 where the distance of either cell is not known, and where a move leads out of the map.
    """
    rows, cols = distance.shape
    around = np.pad(distance, 1, constant_values=np.inf)
    eta = np.ones((rows, cols, len(DIRECTIONS)))
    for direction, (down, right) in enumerate(DIRECTIONS):
        target = around[1 + down :, 1 + right :][:rows, :cols]
        known = np.isfinite(distance) & np.isfinite(target)
        progress = np.subtract(distance, target, where=known, out=np.zeros((rows, cols)))
        np.exp(strength * progress, out=eta[..., direction])
    return eta
