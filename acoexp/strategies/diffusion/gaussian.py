"""tau_ij += gamma * phi(i) * (r - xi) / r, j the neighbour that the field's force points to (Eqs 5-8).

The source phi(i) is the pheromone of the edge from i in that direction, unless another is chosen, so the edge is
multiplied by a constant: 1 + gamma / 3 on a diagonal, 1 + gamma (1 - sqrt 2 / 3) straight ahead. Nothing diffuses
where that move is not allowed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import multiply_one
from acoexp.colony.problem import Problem
from acoexp.grid.field import NO_DIRECTION
from acoexp.grid.moves import SQRT2
from acoexp.parameters import parameter
from acoexp.strategies.diffusion.source import FORCE_EDGE, KERNELS, SOURCES, Spread
from acoexp.strategies.part import Diffusion

RADIUS = 1.5 * SQRT2
"""Diffusion radius r in cells (Eq. 7)."""


class OwnState(NamedTuple):
    """What happens on each cell.

    Attributes:
        sector: uint8[cells], where pheromone diffuses to.
        growth: float64[2], what pheromone on a straight and on a diagonal edge is multiplied by.
        growth_to_alpha: float64[9, 8], its alpha-th power by sector: in row d at d, and 1 elsewhere.
    """

    sector: NDArray[np.uint8]
    growth: NDArray[np.float64]
    growth_to_alpha: NDArray[np.float64]


@compiled
def diffuse(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Strengthen the edge along the force."""
    sector = own.sector[np.uintp(cell)]
    multiply_one(colony, cell, sector, own.growth[sector & 1], own.growth_to_alpha)


def shares() -> NDArray[np.float64]:
    """Return the share (r - xi) / r that reaches a straight and a diagonal neighbour (Eqs 7, 8): float[2]."""
    return 1.0 - np.array([1.0, SQRT2]) / RADIUS


def open_sectors(problem: Problem) -> NDArray[np.uint8]:
    """Return the field's sectors, uint8[rows, cols], without those whose move is not allowed."""
    sector = problem.field.sector
    is_open = (problem.grid.allowed >> np.minimum(sector, 7) & 1).astype(bool) & (sector != NO_DIRECTION)
    return np.where(is_open, sector, NO_DIRECTION).astype(np.uint8)


@dataclass(frozen=True, kw_only=True)
class Gaussian(Diffusion):
    """Diffuses pheromone to the one neighbour that the potential field's force points to (Liu et al. 2017)."""

    gamma: float = parameter(0.01, "diffusion coefficient", minimum=0.0, maximum=1.0)
    source: str = parameter(
        FORCE_EDGE,
        "phi(i): of the edge along the force, or just walked; over the edges into i, or those that leave it",
        choices=SOURCES,
    )

    @property
    def kernel(self) -> Callable[..., Any]:
        """The kernel for the source."""
        return KERNELS.get(self.source, diffuse)

    def prepare(self, problem: Problem) -> OwnState | Spread:
        """Look up, per cell, where pheromone goes."""
        sector = problem.per_cell(open_sectors(problem), border=NO_DIRECTION)
        if self.source != FORCE_EDGE:
            gain = self.gamma * shares()[sector & 1]
            return Spread(sector, np.full_like(sector, NO_DIRECTION), gain, np.zeros_like(gain))
        growth = 1.0 + self.gamma * shares()
        growth_to_alpha = np.ones((9, 8))
        np.fill_diagonal(growth_to_alpha, np.tile(growth**problem.settings.alpha, 4))
        return OwnState(sector, growth, growth_to_alpha)
