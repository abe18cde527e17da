"""eta = exp(strength * (d(cell) - d(target))), d the distance to the goal on a coarse map of the way.

The map is parted into blocks of ``size`` x ``size`` cells, and what hangs together within a block is a *room*.
From room to room it is as far as from centre to centre, where a move leads from one into the other. A cell's
distance is the straight line to the centre of the room that comes next, and what is left from there; in the goal's
room the straight line to the goal. The topology is exact, so no dead end of more than a room attracts; lengths are
not.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.problem import Problem
from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS
from acoexp.parameters import parameter
from acoexp.strategies.heuristic.descent import descent
from acoexp.strategies.part import Heuristic


@dataclass(frozen=True, kw_only=True)
class Coarse(Heuristic):
    """Prefers moves along the way on a map of blocks, which shows dead ends and no details."""

    strength: float = parameter(2.0, "how much one cell of progress counts", minimum=0.0, maximum=100.0)
    size: int = parameter(8, "side of a block in cells", minimum=2, maximum=1024)

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8]; 1 where no way leads to the goal."""
        return descent(coarse_distance(problem.grid, self.size), self.strength)


class _Rooms(NamedTuple):
    """Attributes: room int32[cells]; centre float64[rooms, 2]; doors int[doors, 2], from room to room."""

    room: NDArray[np.int32]
    centre: NDArray[np.float64]
    doors: NDArray[np.int64]


def coarse_distance(grid: Grid, size: int) -> NDArray[np.float64]:
    """Return how far each cell is from the goal by the rooms, float64[rows, cols]; inf where no way leads."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    rooms = _rooms_of(grid, size)
    count, (start, end) = len(rooms.centre), rooms.doors.T
    lengths = np.hypot(*(rooms.centre[start] - rooms.centre[end]).T)
    goal = rooms.room[grid.goal[0] * grid.shape[1] + grid.goal[1]]
    graph = csr_array((lengths, (start, end)), shape=(count, count))
    left, following = dijkstra(graph, indices=goal, return_predecessors=True)  # doors lead both ways
    known = following >= 0
    aim, beyond = np.zeros((count, 2)), np.full(count, np.inf)
    aim[known], beyond[known] = rooms.centre[following[known]], left[following[known]]
    aim[goal], beyond[goal] = grid.goal, 0.0
    row, col = np.indices(grid.shape).reshape(2, -1)
    aim_row, aim_col = aim[rooms.room].T
    distance: NDArray[np.float64] = np.hypot(row - aim_row, col - aim_col) + beyond[rooms.room]
    return distance.reshape(grid.shape)


def _rooms_of(grid: Grid, size: int) -> _Rooms:
    """Part a map into rooms; each obstacle is one by itself, without doors."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    rows, cols = grid.shape
    row, col = np.indices(grid.shape).reshape(2, -1)
    block = row // size * (cols // size + 1) + col // size
    sources, targets = [], []
    for direction, (down, right) in enumerate(DIRECTIONS[:4]):  # the others are these backwards
        source = np.flatnonzero(grid.allowed.ravel() >> direction & 1)
        sources.append(source)
        targets.append(source + down * cols + right)
    source, target = np.concatenate(sources), np.concatenate(targets)
    within = block[source] == block[target]
    edges = np.ones(within.sum(), np.int8), (source[within], target[within])
    _, room = connected_components(coo_array(edges, shape=(rows * cols, rows * cols)), directed=False)
    sizes = np.bincount(room)
    centre = np.stack([np.bincount(room, row) / sizes, np.bincount(room, col) / sizes], axis=1)
    doors = np.unique(np.stack([room[source[~within]], room[target[~within]]], axis=1), axis=0)
    both_ways = np.unique(np.concatenate([doors, doors[:, ::-1]]), axis=0).astype(np.int64)
    return _Rooms(room, centre, both_ways)
