"""The geometric local optimisation of Liu et al. 2017, Sect. 3.3: crossing, saw tooth, circular.

Three rules, in this order, until nothing changes. Each only leaves cells out and joins what remains by an
allowed move that is shorter, so a path never gets longer. Nothing changes after the first time: where circles are
cut no cell has a neighbour on the path beyond the next, which a crossing or a tooth would have.

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

NO_BLOCK = 0
"""A corner of the map's border, which no move crosses."""


class OwnState(NamedTuple):
    """Attributes: place int32[cells], room to look up where on the path a cell is; -1 between two uses."""

    place: NDArray[np.int32]


@compiled
def remove_crossings(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Lead A-B ... C-D, where AB and CD cross, straight from A to D (Eqs 9-16, Fig. 4)."""
    for i in range(count - 1):
        own.place[np.uintp(_block_of_diagonal(colony, cells[i], cells[i + 1]))] = i
    own.place[NO_BLOCK] = -1
    kept = resume = 0
    for i in range(count):
        block = _block_of_diagonal(colony, cells[i], cells[i + 1]) if i + 1 < count else NO_BLOCK
        if i >= resume:
            cells[kept] = cells[i]
            kept += 1
            resume = own.place[np.uintp(block)] + 1
        own.place[np.uintp(block)] = -1
    return kept


@compiled
def _block_of_diagonal(colony: Any, cell: Any, target: Any) -> Any:
    """Return the top left cell of the 2 x 2 block that a diagonal move crosses, ``NO_BLOCK`` of a straight one."""
    upper = min(cell, target)
    distance = max(cell, target) - upper
    across = distance == colony.width - 1
    return upper - across if across or distance == colony.width + 1 else NO_BLOCK


@compiled
def cut_saw_teeth(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Lead A-B-C, where the angle at B is 45 degrees, straight from A to C (Eq. 17, Fig. 5)."""
    kept = 0
    for i in range(count):
        while kept >= 2 and _is_tooth(colony, cells[np.uintp(kept - 2)], cells[i]):
            kept -= 1
        cells[np.uintp(kept)] = cells[i]
        kept += 1
    return kept


@compiled
def _is_tooth(colony: Any, a: Any, c: Any) -> Any:
    """Tell whether two moves turned back by 135 degrees: they lead from a cell to one straight beside it."""
    distance = abs(c - a)
    return distance == 1 or distance == colony.width


@compiled
def cut_circles(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """From each cell go on to the neighbour that comes last on the path (Sect. 3.3, Fig. 6)."""
    for i in range(count):
        own.place[np.uintp(cells[i])] = i
    kept = resume = 0
    for i in range(count):
        cell = np.uintp(cells[i])
        if i >= resume:
            cells[kept] = cells[i]
            kept += 1
            resume = _last_neighbour(colony, own, cells[i])
        own.place[cell] = -1
    return kept


@compiled
def _last_neighbour(colony: Any, own: Any, cell: Any) -> Any:
    """Return the latest place on the path that an allowed move from a cell leads to, -1 if there is none.

    A straight move to a cell that is on a path is always allowed.
    """
    width, place = colony.width, own.place
    diagonal = max(
        max(_beyond(colony, own, cell, 1, 1 - width), _beyond(colony, own, cell, 3, -1 - width)),
        max(_beyond(colony, own, cell, 5, width - 1), _beyond(colony, own, cell, 7, width + 1)),
    )
    beside = max(place[np.uintp(cell + 1)], place[np.uintp(cell - 1)])
    return max(diagonal, max(beside, max(place[np.uintp(cell - width)], place[np.uintp(cell + width)])))


@compiled
def _beyond(colony: Any, own: Any, cell: Any, direction: Any, offset: Any) -> Any:
    """Return the place on the path of the cell that a move leads to, -1 if it is not allowed, or not on it."""
    place = own.place[np.uintp(cell + offset)]
    return place if colony.allowed[np.uintp(cell)] >> direction & 1 else np.int32(-1)


@compiled
def _has_detour(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Tell whether any cell has a neighbour on the path beyond the next: else no rule finds anything to cut."""
    for i in range(count):
        own.place[np.uintp(cells[i])] = i
    found, i = False, 0
    while i < count and not found:
        found = _last_neighbour(colony, own, cells[i]) > i + 1
        i += 1
    for i in range(count):
        own.place[np.uintp(cells[i])] = -1
    return found


@compiled
def optimise(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Apply the three rules, in the paper's order: once, as then nothing changes any more."""
    if not _has_detour(colony, own, cells, count):
        return count
    count = remove_crossings(colony, own, cells, count)
    count = cut_saw_teeth(colony, own, cells, count)
    return cut_circles(colony, own, cells, count)


@dataclass(frozen=True, kw_only=True)
class Geometric(Post):
    """Removes crossings, saw teeth and circles from every ant's path (Liu et al. 2017)."""

    kernel = staticmethod(optimise)

    def prepare(self, problem: Problem) -> OwnState:
        """Make room to look cells up."""
        rows, _ = problem.grid.shape
        return OwnState(np.full((rows + 2) * problem.width, -1, dtype=np.int32))
