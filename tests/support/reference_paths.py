"""Moves and paths in plain Python, and how the geometric post-optimiser shortens them: a part of ``reference``.

Nothing here comes from ``acoexp`` but a map's data. Cells are (row, column), row 0 on top; directions 0..7
are E, NE, N, NW, W, SW, S, SE, so even ones are straight and odd ones diagonal.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

Cell = tuple[int, int]
Path = list[Cell]
Pair = tuple[int, int]
"""A length as (straight, diagonal) moves."""
Moves = dict[Cell, dict[int, Cell]]
"""By cell and direction: where that move leads. Moves that are not allowed are not there."""

STEPS = [(0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0), (1, 1)]
ROOT2 = math.sqrt(2)


def moves_of(grid: Any) -> Moves:
    """Every move that the map's rule for diagonals allows; outside the map counts as blocked."""
    free = {(r, c) for r, row in enumerate(grid.obstacles) for c, wall in enumerate(row) if not wall}
    blocked_beside = {"free": 2, "no_squeeze": 1, "no_cut": 0, "four": -1}[grid.moves]
    allowed: Moves = {cell: {} for cell in free}
    for r, c in free:
        for d, (down, right) in enumerate(STEPS):
            beside = sum(b not in free for b in [(r + down, c), (r, c + right)])
            if (r + down, c + right) in free and (d % 2 == 0 or beside <= blocked_beside):
                allowed[r, c][d] = (r + down, c + right)
    return allowed


def pair_of(path: Path) -> Pair:
    """A path's (straight, diagonal) moves."""
    diagonal = sum(a[0] != b[0] and a[1] != b[1] for a, b in pairwise(path))
    return len(path) - 1 - diagonal, diagonal


def length_of(pair: Pair) -> float:
    return pair[0] + pair[1] * ROOT2


def without_crossings(path: Path) -> Path:
    """Of two diagonals of one 2 x 2 block, drop what lies between: from the first cell on to the last one.

    Only moves that cross, or one move walked twice, have the same middle.
    """
    last = {(a[0] + b[0], a[1] + b[1]): j for j, (a, b) in enumerate(pairwise(path))}
    kept, i = [], 0
    while i < len(path) - 1:
        kept.append(path[i])
        i = last[path[i][0] + path[i + 1][0], path[i][1] + path[i + 1][1]] + 1
    return [*kept, path[-1]]


def without_saw_teeth(path: Path) -> Path:
    """Drop the middle one of three cells where the path turns by 135 degrees: where its angle is 45."""
    kept: Path = []
    for cell in path:
        while len(kept) > 1 and (direction_of(kept[-1], cell) - direction_of(kept[-2], kept[-1])) % 8 in (3, 5):
            kept.pop()
        kept.append(cell)
    return kept


def without_detours(path: Path, moves: Moves) -> Path:
    """From each cell go on to that neighbour which comes last on the path (Fig. 6)."""
    place = {cell: i for i, cell in enumerate(path)}
    kept = [path[0]]
    while kept[-1] != path[-1]:
        kept.append(path[max(place.get(cell, -1) for cell in moves[kept[-1]].values())])
    return kept


def optimised(path: Path, moves: Moves) -> Path:
    """The geometric post-optimiser (Sect. 3.3): its three rules, until nothing changes."""
    shorter = without_detours(without_saw_teeth(without_crossings(path)), moves)
    return path if shorter == path else optimised(shorter, moves)


def direction_of(a: Cell, b: Cell) -> int:
    return STEPS.index((b[0] - a[0], b[1] - a[1]))
