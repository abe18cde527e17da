"""The exact filter: a candidate's optimum, by label correcting over pairs of moves, in some ten microseconds."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.grid.moves import SQRT2
from acoexp.reconstruct.published import RULES

SIZE = 20
"""Rows and columns of the paper's maps."""

_WIDTH = SIZE + 2
_CELLS = _WIDTH * _WIDTH
_START, _GOAL = _WIDTH + 1, SIZE * _WIDTH + SIZE
_STEPS = np.array([1, 1 - _WIDTH, -_WIDTH, -1 - _WIDTH, -1, _WIDTH - 1, _WIDTH, _WIDTH + 1])


@compiled
def _spread(free: Any, tolerated: Any, steps: Any, pairs: Any, queue: Any, waiting: Any) -> int:
    """Fill ``pairs`` with each cell's distance from the start; return how many cells can be reached.

    Args:
        free: uint8[cells] of the bordered map.
        tolerated: How many of the two cells beside a diagonal may be blocked.
        steps: int64[8].
        pairs: int64[cells, 2], filled with (straight, diagonal); straight is -1 where no way leads.
        queue: int64[cells], room for the cells whose neighbours are to be looked at again: a ring.
        waiting: uint8[cells], which of them are in it.
    """
    for cell in range(free.size):
        pairs[cell, 0] = -1
        waiting[cell] = 0
    pairs[_START, 0] = pairs[_START, 1] = 0
    queue[0], head, count, reached = _START, 0, 1, 1
    while count:
        cell = queue[head]
        head = (head + 1) % queue.size
        count -= 1
        waiting[cell] = 0
        for direction in range(8):
            target = cell + steps[direction]
            if not free[target]:
                continue
            straight, diagonal = pairs[cell, 0], pairs[cell, 1]
            if direction & 1:
                beside = 2 - free[cell + steps[direction - 1]] - free[cell + steps[(direction + 1) & 7]]
                if beside > tolerated:
                    continue
                diagonal += 1
            else:
                straight += 1
            before = pairs[target, 0]
            if before < 0:
                reached += 1
            elif straight + diagonal * SQRT2 >= before + pairs[target, 1] * SQRT2:
                continue
            pairs[target, 0], pairs[target, 1] = straight, diagonal
            if not waiting[target]:
                waiting[target] = 1
                queue[(head + count) % queue.size] = target
                count += 1
    return reached


@compiled
def _flood(free: Any, tolerated: Any, steps: Any, moves: Any, here: Any, there: Any) -> Any:
    """Return the walks of exactly so many moves from start to goal: bit d is set if one has d diagonals.

    Args:
        free, tolerated, steps: As for ``_spread``.
        moves: How many.
        here, there: int64[cells], room for what holds after each move, cell by cell.
    """
    for cell in range(free.size):
        here[cell] = there[cell] = 0
    here[_START] = 1
    for _ in range(moves):
        for cell in range(_START, _GOAL + 1):
            ways = 0
            if free[cell]:
                for direction in range(8):
                    source = cell + steps[direction]
                    if not here[source]:
                        continue
                    if direction & 1:
                        beside = 2 - free[cell + steps[direction - 1]] - free[cell + steps[(direction + 1) & 7]]
                        if beside <= tolerated:
                            ways |= here[source] << 1
                    else:
                        ways |= here[source]
            there[cell] = ways
        for cell in range(free.size):
            here[cell] = there[cell]
    return here[_GOAL]


class Screen:
    """Exact optima under one rule for diagonals, one map after the other."""

    def __init__(self, moves: str) -> None:
        self._tolerated = 2 - RULES.index(moves)
        self._free = np.zeros((_WIDTH, _WIDTH), dtype=np.uint8)
        self._pairs = np.empty((_CELLS, 2), dtype=np.int64)
        self._queue = np.empty(_CELLS, dtype=np.int64)
        self._waiting = np.empty(_CELLS, dtype=np.uint8)
        self._walks = np.empty(_CELLS, dtype=np.int64), np.empty(_CELLS, dtype=np.int64)

    def optimum(self, obstacles: NDArray[np.bool_]) -> tuple[int, int] | None:
        """Return the optimum from corner to corner as (straight, diagonal) moves.

        None if there is no way, or some free cell cannot be reached: the paper's maps have no such pockets.

        Args:
            obstacles: bool[20, 20].
        """
        self._free[1:-1, 1:-1] = ~obstacles
        flat = self._free.ravel()
        reached = _spread(flat, self._tolerated, _STEPS, self._pairs, self._queue, self._waiting)
        if self._pairs[_GOAL, 0] < 0 or reached != SIZE * SIZE - int(obstacles.sum()):
            return None
        return int(self._pairs[_GOAL, 0]), int(self._pairs[_GOAL, 1])

    def leads(self, obstacles: NDArray[np.bool_], pair: tuple[int, int]) -> bool:
        """Tell whether some walk from corner to corner has exactly so many (straight, diagonal) moves.

        Args:
            obstacles: bool[20, 20].
            pair: The moves, diagonal ones at most 62.
        """
        straight, diagonal = pair
        self._free[1:-1, 1:-1] = ~obstacles
        walks = _flood(self._free.ravel(), self._tolerated, _STEPS, straight + diagonal, *self._walks)
        return bool(int(walks) >> diagonal & 1)
