"""p(move) = tau^alpha * eta^beta, relative to the moves still open (Liu et al. 2017, Sect. 3.4, step 4)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.random import uniform
from acoexp.colony.state import LOST
from acoexp.colony.tabu import is_open
from acoexp.strategies.part import Choice


@compiled
def _open_weight(colony: Any, cell: Any, direction: Any, offset: Any) -> Any:
    """Return the weight of a move, 0 if its target is tabu."""
    return colony.weight[np.uintp(cell * 8 + direction)] * colony.untouched[np.uintp(cell + offset)]


@compiled
def spin(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    """Choose a move with a probability in proportion to its weight.

    The running sums are added up in three levels instead of seven, which halves the wait for them. They never
    decrease, and a weight of 0 leaves its sum exactly as the one before: the move it stands for, tabu or not
    allowed, is never taken.
    """
    width = colony.width
    w0 = _open_weight(colony, cell, 0, 1)
    w1 = _open_weight(colony, cell, 1, 1 - width)
    w2 = _open_weight(colony, cell, 2, -width)
    w3 = _open_weight(colony, cell, 3, -1 - width)
    w4 = _open_weight(colony, cell, 4, -1)
    w5 = _open_weight(colony, cell, 5, width - 1)
    w6 = _open_weight(colony, cell, 6, width)
    w7 = _open_weight(colony, cell, 7, width + 1)
    s1, s5 = w0 + w1, w4 + w5
    s2, s3 = s1 + w2, s1 + (w2 + w3)
    s6, s7 = s5 + w6, s5 + (w6 + w7)
    total = s3 + s7
    ball = uniform(colony.random) * total
    if not ball < total:  # all weights are 0, or the product was rounded up
        return _spin_rarely(colony, cell)
    return (
        0  # without the JIT, the sum of NumPy's truth values would be one
        + (w0 <= ball)
        + (s1 <= ball)
        + (s2 <= ball)
        + (s3 <= ball)
        + (s3 + w4 <= ball)
        + (s3 + s5 <= ball)
        + (s3 + s6 <= ball)
    )


@compiled
def _spin_rarely(colony: Any, cell: Any) -> Any:
    """Choose evenly among the open moves of the largest weight: all of them where every weight is 0."""
    count, largest = 0, 0.0
    for direction in range(8):
        if is_open(colony, cell, direction):
            weight = colony.weight[cell * 8 + direction]
            if weight > largest:
                count, largest = 0, weight
            if weight == largest:
                count += 1
    if count == 0:
        return LOST
    nth = int(uniform(colony.random) * count)
    for direction in range(8):
        if is_open(colony, cell, direction) and colony.weight[cell * 8 + direction] == largest:
            if nth == 0:
                return direction
            nth -= 1
    return LOST


@dataclass(frozen=True, kw_only=True)
class Roulette(Choice):
    """Chooses in proportion to pheromone^alpha * heuristic^beta; evenly where every weight underflows."""

    kernel = staticmethod(spin)
