"""What heuristics share: a number of each cell, as seen by the moves that lead into it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS

_STRIP = 2**12
"""Cells whose moves are filled in at a time: as many as the processor keeps at hand."""


def goal_distance(grid: Grid) -> NDArray[np.float64]:
    """Return the straight line to the goal from each cell and from a border around the map, in cells.

    float64[rows + 2, cols + 2], as moves off the map have a target too.
    """
    rows, cols = grid.shape
    row, col = np.ogrid[-1 : rows + 1, -1 : cols + 1]
    distance: NDArray[np.float64] = np.hypot(row - grid.goal[0], col - grid.goal[1])
    return distance


def at_targets(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return for each move what its target has, float64[rows, cols, 8].

    Args:
        values: float64[rows + 2, cols + 2], a border around the map included.
    """
    rows, cols = (size - 2 for size in values.shape)
    found = np.empty((rows, cols, 8))
    height = max(1, _STRIP // cols)
    for top in range(0, rows, height):
        strip = found[top : top + height]
        for direction, (down, right) in enumerate(DIRECTIONS):
            strip[..., direction] = values[1 + top + down :, 1 + right :][: len(strip), :cols]
    return found
