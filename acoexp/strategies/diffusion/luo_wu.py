"""tau_ij += gamma * phi(i) * (r - xi) / r * nearness_j, j the two neighbours on either side of the force.

A *reconstruction* of the diffusion in ACO-PF (Luo and Wu 2010): no public source gives its formulas. Known is
that the resultant force guides the ants and that pheromone diffuses; that it splits between the two grid
directions that enclose the force, each in proportion to its nearness in angle, is ours. Eq. 6's cone gives the
shares by distance. phi(i) is the pheromone of the nearest of those edges that is an allowed move, unless another
source is chosen.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import deposit, level, multiply_here
from acoexp.colony.problem import Problem
from acoexp.grid.field import NO_DIRECTION
from acoexp.parameters import parameter
from acoexp.strategies.diffusion.gaussian import shares
from acoexp.strategies.diffusion.source import FORCE_EDGE, KERNELS, SOURCES, Spread
from acoexp.strategies.part import Diffusion


class OwnState(NamedTuple):
    """What happens on each cell, all [cells].

    Attributes:
        near, far: uint8, the two directions beside the force, the nearer first; ``NO_DIRECTION`` if closed.
        growth: float64, what pheromone on the near edge is multiplied by; growth_to_alpha: its power.
        side: float64, how much of the near edge's pheromone the far edge gets.
    """

    near: NDArray[np.uint8]
    far: NDArray[np.uint8]
    growth: NDArray[np.float64]
    growth_to_alpha: NDArray[np.float64]
    side: NDArray[np.float64]


@compiled
def diffuse(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Strengthen the two edges beside the force."""
    near, far = own.near[cell], own.far[cell]
    if near == NO_DIRECTION:
        return
    if far != NO_DIRECTION:
        deposit(colony, cell * 8 + far, own.side[cell] * level(colony, cell * 8 + near))
    multiply_here(colony, cell * 8 + near, own.growth[cell], own.growth_to_alpha[cell])


@dataclass(frozen=True, kw_only=True)
class LuoWu(Diffusion):
    """Diffuses pheromone to the two neighbours beside the field's force; a reconstruction of Luo and Wu 2010."""

    gamma: float = parameter(0.01, "diffusion coefficient", minimum=0.0, maximum=1.0)
    source: str = parameter(
        FORCE_EDGE,
        "phi(i): of the edge nearest to the force, or just walked; over the edges into i, or those that leave it",
        choices=SOURCES,
    )

    @property
    def kernel(self) -> Callable[..., Any]:
        """The kernel for the source."""
        return KERNELS.get(self.source, diffuse)

    def prepare(self, problem: Problem) -> OwnState | Spread:
        """Split each cell's force between the two directions beside it."""
        force = problem.field.force
        turn = np.arctan2(force[..., 1], force[..., 0]) / (np.pi / 4)
        lower = np.floor(turn).astype(np.int64)
        above = turn - lower
        near_is_upper = above >= 0.5
        near = np.where(near_is_upper, lower + 1, lower) % 8
        far = np.where(near_is_upper, lower, lower + 1) % 8
        nearness = np.where(near_is_upper, above, 1.0 - above)

        acts = (force != 0.0).any(axis=-1)
        near_open, far_open = (acts & (problem.grid.allowed >> d & 1).astype(bool) for d in (near, far))
        only_far = far_open & ~near_open
        near, far = np.where(only_far, far, near), np.where(near_open & far_open, far, NO_DIRECTION)
        near_part = np.where(only_far, 1.0 - nearness, nearness)
        near = np.where(near_open | far_open, near, NO_DIRECTION)

        share = self.gamma * shares()
        growth = 1.0 + share[near % 2] * near_part
        side = share[far % 2] * (1.0 - nearness)
        directions = (problem.per_cell(d.astype(np.uint8), border=NO_DIRECTION) for d in (near, far))
        if self.source != FORCE_EDGE:
            gains = (problem.per_cell(n, border=0.0) for n in (share[near % 2] * near_part, side))
            return Spread(*directions, *gains)
        numbers = (problem.per_cell(n, border=1.0) for n in (growth, growth**problem.settings.alpha, side))
        return OwnState(*directions, *numbers)
