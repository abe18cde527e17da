"""A lattice of chambers with walls of one cell between them: what mazes and maps of rooms have in common."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

Openings = NDArray[np.bool_]


def spans(cells: int, side: int) -> NDArray[np.int64]:
    """Return how many cells chamber, wall, chamber and so on take of a side; the last one takes the rest."""
    chambers = max(1, (cells + 1) // (side + 1))
    taken = np.ones(2 * chambers - 1, dtype=np.int64)
    taken[::2] = side
    taken[-1] = cells - taken[:-1].sum()
    return taken


class Walls(NamedTuple):
    """Which walls are open.

    Attributes:
        below: bool[rows - 1, cols], between a chamber and the one below it.
        beside: bool[rows, cols - 1], between a chamber and the one to its right.
    """

    below: Openings
    beside: Openings


def open_walls(rng: Generator, rows: int, cols: int, share: float) -> Walls:
    """Open walls of a lattice so that one way leads from each chamber to each other, and a share of the others.

    The ways are a spanning tree, the lightest under weights by chance (Kruskal 1956): any algorithm finds it.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import minimum_spanning_tree

    number = np.arange(rows * cols).reshape(rows, cols)
    first = np.concatenate([number[:-1].ravel(), number[:, :-1].ravel()])
    second = np.concatenate([number[1:].ravel(), number[:, 1:].ravel()])
    weights = 1.0 + rng.random(first.size)
    extra = rng.random(first.size) < share
    tree = minimum_spanning_tree(coo_array((weights, (first, second)), shape=(number.size,) * 2)).tocoo()
    chosen = np.isin(first * number.size + second, tree.row.astype(np.int64) * number.size + tree.col)
    below, beside = np.split(chosen | extra, [(rows - 1) * cols])
    return Walls(below.reshape(rows - 1, cols), beside.reshape(rows, cols - 1))
