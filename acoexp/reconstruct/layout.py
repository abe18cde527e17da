"""Layouts: a few rectangles on 20 x 20 cells, and how one layout becomes another."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from acoexp.reconstruct.screen import SIZE

Layout = NDArray[np.int64]
"""Rectangles, int64[n, 4] as (top, left, bottom, right), bottom and right excluded."""

FEWEST, MOST = 5, 16
"""Rectangles on a map."""

LONGEST = 12
"""Cells along a side."""

THINNEST, DENSEST = 0.15, 0.40
"""Share of cells that are obstacles."""


def paint(layout: Layout) -> NDArray[np.bool_]:
    """Return the obstacles, bool[20, 20]; rectangles may overlap."""
    obstacles = np.zeros((SIZE, SIZE), dtype=bool)
    for top, left, bottom, right in layout.tolist():
        obstacles[top:bottom, left:right] = True
    return obstacles


def is_map(obstacles: NDArray[np.bool_]) -> bool:
    """Tell whether start and goal are free, and the map is neither empty nor crammed."""
    return not (obstacles[0, 0] or obstacles[-1, -1]) and THINNEST < obstacles.mean() < DENSEST


def random_layout(rng: Generator) -> Layout:
    """Return some random rectangles."""
    return np.array([_random_rectangle(rng) for _ in range(rng.integers(8, 13))])


def mutate(layout: Layout, rng: Generator) -> Layout:
    """Return a neighbour: one to three rectangles moved, resized, added, removed or replaced."""
    changed = layout.copy()
    for _ in range(1 + min(rng.geometric(0.6) - 1, 2)):
        which, kind = rng.integers(len(changed)), rng.random()
        if kind < 0.35:
            changed[which] += np.tile(rng.integers(-2, 3, size=2), 2)
        elif kind < 0.75:
            changed[which, rng.integers(4)] += rng.choice([-2, -1, -1, 1, 1, 2])
        elif kind < 0.82 and len(changed) < MOST:
            changed = np.vstack([changed, _random_rectangle(rng)])
        elif kind < 0.89 and len(changed) > FEWEST:
            changed = np.delete(changed, which, axis=0)
        else:
            changed[which] = _random_rectangle(rng)
    return changed


def is_layout(layout: Layout) -> bool:
    """Tell whether every rectangle lies on the map, has at least two cells, and is not too long."""
    sides = layout[:, 2:] - layout[:, :2]
    return bool(
        layout.min() >= 0
        and layout.max() <= SIZE
        and sides.min() >= 1
        and sides.max() <= LONGEST
        and sides.prod(axis=1).min() >= 2
    )


def _random_rectangle(rng: Generator) -> Layout:
    height, width = rng.integers(1, 7, size=2)
    if height == width == 1:
        width += 1
    top, left = rng.integers(0, SIZE - height + 1), rng.integers(0, SIZE - width + 1)
    return np.array([top, left, top + height, left + width])
