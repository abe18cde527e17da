"""The exact optimum of a grid, and the exact distances to its goal, by scipy's Dijkstra."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.moves import DIRECTIONS, SQRT2

if TYPE_CHECKING:
    from scipy.sparse import csr_array


def shortest_path(
    allowed: NDArray[np.uint8], start: tuple[int, int], goal: tuple[int, int]
) -> NDArray[np.int64] | None:
    """Return one shortest path from start to goal as cells int[n, 2], or None if there is no way.

    Args:
        allowed: The neighbour table, uint8[rows, cols]: bit d is set where the move in direction d is allowed.
        start: Its first cell, (row, column).
        goal: Its last cell.

    Ties between paths of the same length are broken by the solver. The lengths of two different pairs
    (straight, diagonal) differ by far more than the rounding of their sums, so the optimum is exact.
    """
    from scipy.sparse.csgraph import dijkstra  # a quarter of what --help would cost

    cols = allowed.shape[1]
    first, last = (row * cols + col for row, col in (start, goal))
    _, before = dijkstra(_move_graph(allowed), indices=first, return_predecessors=True)
    if before[last] < 0:
        return None
    cells = [last]
    while cells[-1] != first:
        cells.append(int(before[cells[-1]]))
    return np.stack(np.divmod(np.array(cells[::-1], dtype=np.int64), cols), axis=1)


def distances(allowed: NDArray[np.uint8], goal: tuple[int, int]) -> NDArray[np.float64]:
    """Return how long the shortest way from each cell to the goal is, float64[rows, cols]; inf where none leads.

    Args:
        allowed: The neighbour table, as for :func:`shortest_path`. Every rule allows a move both ways.
        goal: Where the ways end, (row, column).
    """
    from scipy.sparse.csgraph import dijkstra

    rows, cols = allowed.shape
    found: NDArray[np.float64] = dijkstra(_move_graph(allowed), indices=goal[0] * cols + goal[1])
    return found.reshape(rows, cols)


def _move_graph(allowed: NDArray[np.uint8]) -> csr_array:
    """Return the allowed moves as a sparse matrix of lengths, cell by cell."""
    from scipy.sparse import csr_array

    rows, cols = allowed.shape
    table = allowed.ravel()
    sources, targets, lengths = [], [], []
    for direction, (down, right) in enumerate(DIRECTIONS):
        source = np.flatnonzero(table >> direction & 1).astype(np.int32)
        sources.append(source)
        targets.append(source + np.int32(down * cols + right))
        lengths.append(np.full(source.size, SQRT2 if direction % 2 else 1.0))
    edges = np.concatenate(lengths), (np.concatenate(sources), np.concatenate(targets))
    return csr_array(edges, shape=(rows * cols, rows * cols))
