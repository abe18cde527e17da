"""What phi(i) of Eq. 6 may be, with pheromone on edges, other than that of the edge from i along the force.

The paper calls it "the amount of pheromone diffusion source" of the ant's cell i, and pheromone lies on edges.
A diffusion adds a gain times phi(i) to one edge from i, or to two. The kernels here serve every diffusion whose
own state is a ``Spread``. Where phi(i) is the pheromone of the edge that gets it, a factor is enough, and faster:
that kernel is the diffusion's own.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import deposit, level
from acoexp.colony.state import NO_WAY_HERE
from acoexp.grid.field import NO_DIRECTION


class Spread(NamedTuple):
    """Where pheromone goes from each cell, all [cells].

    Attributes:
        near, far: uint8, the directions of the edges that get some; ``NO_DIRECTION`` for none.
        near_gain, far_gain: float64, how much of phi(i) each gets.
    """

    near: NDArray[np.uint8]
    far: NDArray[np.uint8]
    near_gain: NDArray[np.float64]
    far_gain: NDArray[np.float64]


@compiled
def _spread(colony: Any, own: Any, cell: Any, phi: Any) -> None:
    if own.near[cell] != NO_DIRECTION:
        deposit(colony, cell * 8 + own.near[cell], own.near_gain[cell] * phi)
    if own.far[cell] != NO_DIRECTION:
        deposit(colony, cell * 8 + own.far[cell], own.far_gain[cell] * phi)


@compiled
def from_walked_edge(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Spread the pheromone of the edge that the ant just walked; nothing on the start."""
    if came != NO_WAY_HERE:
        _spread(colony, own, cell, level(colony, (cell - colony.offsets[came]) * 8 + came))


@compiled
def from_sum_in(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Spread the sum of the pheromone of all edges that lead to the cell."""
    phi = 0.0
    for direction in range(8):
        if colony.allowed[cell] >> direction & 1:  # moves are allowed both ways, or neither
            phi += level(colony, (cell + colony.offsets[direction]) * 8 + (direction ^ 4))
    _spread(colony, own, cell, phi)


@compiled
def from_mean_out(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Spread the mean of the pheromone of all edges that leave the cell, tabu or not."""
    phi, count = 0.0, 0
    for direction in range(8):
        if colony.allowed[cell] >> direction & 1:
            phi += level(colony, cell * 8 + direction)
            count += 1
    if count > 0:
        _spread(colony, own, cell, phi / count)


@compiled
def from_max_out(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Spread the highest level of all edges that leave the cell, tabu or not."""
    phi = 0.0
    for direction in range(8):
        if colony.allowed[cell] >> direction & 1:
            phi = max(phi, level(colony, cell * 8 + direction))
    _spread(colony, own, cell, phi)


FORCE_EDGE = "force_edge"
"""The source that each diffusion has a kernel of its own for."""

KERNELS: dict[str, Callable[..., Any]] = {
    "walked_edge": from_walked_edge,
    "sum_in": from_sum_in,
    "mean_out": from_mean_out,
    "max_out": from_max_out,
}
"""The kernels for a ``Spread``, by source."""

SOURCES = (FORCE_EDGE, *KERNELS)
