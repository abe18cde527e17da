"""Moves: the eight directions of a step, and the rules for diagonals, past obstacle corners or at all."""

from __future__ import annotations

from typing import Literal, TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

DIRECTIONS: tuple[tuple[int, int], ...] = (
    (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0), (1, 1),
)  # fmt: skip
"""Step (rows, columns) of direction 0..7: east, then counter-clockwise, as in the paper's Fig. 2.

Even directions are straight (length 1), odd ones diagonal (length sqrt 2).
"""

SQRT2 = 2.0**0.5

MoveRule = Literal["free", "no_squeeze", "no_cut", "four"]
"""When a diagonal move is allowed, its target being free:

``free``: always; ``no_squeeze``: unless both cells beside it are obstacles; ``no_cut``: unless either is;
``four``: never, which leaves the four straight moves.
"""

MOVE_RULES: tuple[str, ...] = get_args(MoveRule)

Count = TypeVar("Count", float, NDArray[np.float64])


def path_length(straight: Count, diagonal: Count) -> Count:
    """Return the length of a path of so many straight and diagonal moves, or those of several.

    Two different pairs never give the same float below some 10^7 moves, and equal pairs always do, so
    lengths made here may be compared exactly.
    """
    return straight + diagonal * SQRT2


def follow(start: tuple[int, int], moves: NDArray[np.uint8]) -> NDArray[np.int64]:
    """Return the cells, int[n + 1, 2], that n moves lead over from a start."""
    steps = np.array(DIRECTIONS, dtype=np.int64)[moves]
    return np.concatenate([[start], start + np.cumsum(steps, axis=0)])


def allowed_moves(obstacles: NDArray[np.bool_], rule: str) -> NDArray[np.uint8]:
    """Return the neighbour table of a map: which moves each cell allows.

    Args:
        obstacles: bool[rows, cols], True where a robot cannot be.
        rule: A :data:`MoveRule`.

    Returns:
        uint8[rows, cols]; bit d is set where the move in direction d is allowed. An obstacle allows none.
    """
    rows, cols = obstacles.shape
    walled = np.ones((rows + 2, cols + 2), dtype=bool)
    walled[1:-1, 1:-1] = obstacles

    def shifted(step: tuple[int, int]) -> NDArray[np.bool_]:
        return walled[1 + step[0] : 1 + step[0] + rows, 1 + step[1] : 1 + step[1] + cols]

    table = np.zeros((rows, cols), dtype=np.uint8)
    for direction, step in enumerate(DIRECTIONS):
        if direction % 2 == 1 and rule == "four":
            continue
        allowed = ~obstacles & ~shifted(step)
        if direction % 2 == 1 and rule != "free":
            beside = shifted((step[0], 0)), shifted((0, step[1]))
            allowed &= ~(beside[0] & beside[1]) if rule == "no_squeeze" else ~(beside[0] | beside[1])
        table |= allowed.astype(np.uint8) << direction
    return table
