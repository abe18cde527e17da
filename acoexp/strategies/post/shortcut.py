"""Shortcuts: from each cell straight on to the farthest of the path that a run leads to, again and again.

A run makes all its diagonal moves and then all its straight ones, or the other way round; under the rule ``four``
all along a column and then all along a row, or the other way round: the shortest way there is between two cells.
The farthest cell is searched in steps that double, then halve. On large maps little is left for the colony to do
then: ``alpha=0`` beside it shows how little.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.problem import Problem
from acoexp.parameters import parameter
from acoexp.strategies.part import Post
from acoexp.strategies.post.geometric import optimise as optimise_geometrically


class OwnState(NamedTuple):
    """What it works with.

    Attributes:
        place: int32[cells], room to look up where a cell is.
        geometric: Whether the geometric rules come first.
        diagonals: Whether the map's rule has diagonal moves.
    """

    place: NDArray[np.int32]
    geometric: bool
    diagonals: bool


@compiled
def _run(colony: Any, own: Any, cell: Any, target: Any, in_turn: Any, cells: Any, at: Any) -> Any:
    """Return the moves of a run, 0 if it is blocked; write where they lead from a place in ``cells`` on.

    It has two legs, of which the first one comes first if they are ``in_turn``. Nothing is written where ``at`` is
    negative.
    """
    down, right = target // colony.width - cell // colony.width, target % colony.width - cell % colony.width
    ahead, aside = np.sign(down) * colony.width, np.sign(right)
    first, second, of_first, of_second = ahead, aside, abs(down), abs(right)
    if own.diagonals:
        first, second = ahead + aside, ahead if abs(down) > abs(right) else aside
        of_first, of_second = min(abs(down), abs(right)), abs(abs(down) - abs(right))
    moves = of_first + of_second
    for move in range(moves):
        is_first = move < of_first if in_turn else move >= of_second
        offset = first if is_first else second
        if not colony.allowed[cell] >> colony.direction_of[offset + colony.width + 1] & 1:
            return 0
        cell += offset
        if at >= 0:
            cells[at + move] = cell
    return moves


@compiled
def _reaches(colony: Any, own: Any, cells: Any, start: Any, place: Any) -> Any:
    """Tell how a run leads to a place on the path: its legs in turn 1, the other way round 2, not at all 0."""
    if _run(colony, own, start, np.int64(cells[place]), True, cells, -1) > 0:
        return 1
    return 2 if _run(colony, own, start, np.int64(cells[place]), False, cells, -1) > 0 else 0


@compiled
def _farthest(colony: Any, own: Any, cells: Any, start: Any, place: Any, last: Any) -> Any:
    """Return the farthest place on the path, from a place on, that a run leads to from a cell."""
    stride, grows = 1, True
    while stride > 0:
        reached = place + stride <= last and _reaches(colony, own, cells, start, place + stride) > 0
        if reached:
            place += stride
        else:
            grows = False
        stride = stride * 2 if grows else stride // 2
    return place


@compiled
def straighten(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Go over a path once, and return how many cells are left."""
    kept = place = 0
    while place < count - 1:
        start = np.int64(cells[kept])
        place = _farthest(colony, own, cells, start, place + 1, count - 1)
        in_turn = _reaches(colony, own, cells, start, place) == 1
        kept += _run(colony, own, start, np.int64(cells[place]), in_turn, cells, kept + 1)
    return kept + 1


@compiled
def cut_loops(own: Any, cells: Any, count: Any) -> Any:
    """Go on from each cell where the path leaves it for the last time: runs may lead over one cell twice."""
    for place in range(count):
        own.place[cells[place]] = place
    kept = resume = 0
    for place in range(count):
        cell = cells[place]
        if place >= resume:
            cells[kept] = cell
            kept += 1
            resume = own.place[cell] + 1
        if own.place[cell] == place:
            own.place[cell] = -1
    return kept


@compiled
def _straight_moves(colony: Any, cells: Any, count: Any) -> Any:
    """Return how many moves of a path are straight."""
    straight = 0
    for place in range(1, count):
        straight += 1 - (colony.direction_of[cells[place] - cells[place - 1] + colony.width + 1] & 1)
    return straight


@compiled
def optimise(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    """Apply the geometric rules, if they come first, and go over the path until it gets no shorter."""
    if own.geometric:
        count = optimise_geometrically(colony, own, cells, count)
    while True:
        before, straight = count, _straight_moves(colony, cells, count)
        count = cut_loops(own, cells, straighten(colony, own, cells, count))
        if count == before and _straight_moves(colony, cells, count) <= straight:  # of so many, more are shorter
            return count


@dataclass(frozen=True, kw_only=True)
class Shortcut(Post):
    """Leads every ant's path straight on wherever nothing is in the way; little is left for the colony then."""

    geometric: bool = parameter(False, "whether crossings, saw teeth and circles go first, as by geometric")

    kernel = staticmethod(optimise)

    def prepare(self, problem: Problem) -> OwnState:
        """Make room to look cells up."""
        rows, _ = problem.grid.shape
        place = np.full((rows + 2) * problem.width, -1, dtype=np.int32)
        return OwnState(place, self.geometric, problem.grid.moves != "four")
