"""The geometric local optimisation of Liu et al. 2017, Sect. 3.3: crossing, saw tooth, circular.

Three rules, in this order, until nothing changes. Each only leaves cells out and joins what remains by an
allowed move that is shorter, so a path never gets longer.

The equations are the paper's as corrected: on a lattice two segments cross strictly inside (Eqs 12-15) only as
the two diagonals of one 2 x 2 block, and the angle of Eq. 17 is worked out from directions, not slopes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.problem import Problem
from acoexp.strategies.part import Post


class OwnState(NamedTuple):
    """Attributes: place int32[cells], room to look up where on the path a cell is; -1 between two uses."""

    place: NDArray[np.int32]


@compiled
def remove_crossings(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Lead A-B ... C-D, where AB and CD cross, straight from A to D (Eqs 9-16, Fig. 4)."""
    for i in range(count - 1):
        block = _block_of_diagonal(colony, cells[i], cells[i + 1])
        if block >= 0:
            own.place[block] = i
    kept = resume = 0
    for i in range(count):
        block = _block_of_diagonal(colony, cells[i], cells[i + 1]) if i + 1 < count else -1
        if i >= resume:
            cells[kept] = cells[i]
            kept += 1
            if block >= 0 and own.place[block] > i:
                resume = own.place[block] + 1
        if block >= 0:
            own.place[block] = -1
    return kept


@compiled
def _block_of_diagonal(colony: Any, cell: Any, target: Any) -> Any:
    """Return the top left cell of the 2 x 2 block that a diagonal move crosses, -1 for a straight move."""
    upper = min(cell, target)
    distance = max(cell, target) - upper
    if distance == colony.width + 1:
        return upper
    return upper - 1 if distance == colony.width - 1 else -1


@compiled
def cut_saw_teeth(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Lead A-B-C, where the angle at B is 45 degrees, straight from A to C (Eq. 17, Fig. 5)."""
    kept = 0
    for i in range(count):
        while kept >= 2 and _is_tooth(colony, cells[kept - 2], cells[kept - 1], cells[i]):
            kept -= 1
        cells[kept] = cells[i]
        kept += 1
    return kept


@compiled
def _is_tooth(colony: Any, a: Any, b: Any, c: Any) -> Any:
    """Tell whether the move from b to c turns back from that from a to b by 135 degrees."""
    arriving = np.int64(colony.direction_of[b - a + colony.width + 1])
    leaving = np.int64(colony.direction_of[c - b + colony.width + 1])
    turn = (leaving - arriving) & 7
    return turn == 3 or turn == 5


@compiled
def cut_circles(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """From each cell go on to the neighbour that comes last on the path (Sect. 3.3, Fig. 6)."""
    for i in range(count):
        own.place[cells[i]] = i
    kept = resume = 0
    for i in range(count):
        cell = cells[i]
        if i >= resume:
            cells[kept] = cell
            kept += 1
            resume = _last_neighbour(colony, own, cell)
        own.place[cell] = -1
    return kept


@compiled
def _last_neighbour(colony: Any, own: Any, cell: Any) -> Any:
    """Return the latest place on the path that an allowed move from a cell leads to, -1 if there is none."""
    last = np.int32(-1)
    for direction in range(8):
        if colony.allowed[cell] >> direction & 1:
            last = max(last, own.place[cell + colony.offsets[direction]])
    return last


@compiled
def optimise(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Apply the three rules, in the paper's order, until nothing changes."""
    while True:
        before = count
        count = remove_crossings(colony, own, cells, count)
        count = cut_saw_teeth(colony, own, cells, count)
        count = cut_circles(colony, own, cells, count)
        if count == before:
            return count


@dataclass(frozen=True, kw_only=True)
class Geometric(Post):
    """Removes crossings, saw teeth and circles from every ant's path (Liu et al. 2017)."""

    kernel = staticmethod(optimise)

    def prepare(self, problem: Problem) -> OwnState:
        """Make room to look cells up."""
        rows, _ = problem.grid.shape
        return OwnState(np.full((rows + 2) * problem.width, -1, dtype=np.int32))
