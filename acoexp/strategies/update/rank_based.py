"""The r-th shortest path of a cycle gets (w - r) Q / L_r, r = 1..w-1, and the run's best one w Q / L* (AS_rank).

Bullnheimer, Hartl and Strauss 1997.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import evaporate, lay
from acoexp.colony.problem import Problem
from acoexp.parameters import parameter
from acoexp.strategies.part import Update


class OwnState(NamedTuple):
    """Attributes: ranks w; ranked bool[ants], room to mark the ants that have their rank."""

    ranks: int
    ranked: NDArray[np.bool_]


@compiled
def update(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    """Evaporate, then let the best ants of the cycle lay by their rank, and the run's best most of all."""
    evaporate(colony, colony.rho)
    for ant in range(colony.ants):
        own.ranked[ant] = False
    for rank in range(1, own.ranks):
        ant = _shortest_left(colony, own, final)
        if ant < 0:
            break
        own.ranked[ant] = True
        lay(colony, final, ant, (own.ranks - rank) * colony.q / final.length[ant])
    if best.length[0] < np.inf:
        lay(colony, best, 0, own.ranks * colony.q / best.length[0])


@compiled
def _shortest_left(colony: Any, own: Any, trails: Any) -> Any:
    """Return the ant with the shortest path that has no rank yet, -1 if there is none."""
    shortest, found = np.inf, -1
    for ant in range(colony.ants):
        if not own.ranked[ant] and trails.length[ant] < shortest:
            shortest, found = trails.length[ant], ant
    return found


@dataclass(frozen=True, kw_only=True)
class RankBased(Update):
    """Only the best ants of a cycle lay, by their rank, and most the run's best (Bullnheimer et al. 1997)."""

    ranks: int = parameter(
        6, "weight w of the run's best path; w - 1 ants of a cycle lay", minimum=1, maximum=100_000
    )

    kernel = staticmethod(update)

    def prepare(self, problem: Problem) -> OwnState:
        """Make room to rank the ants."""
        return OwnState(self.ranks, np.zeros(problem.settings.ants, dtype=np.bool_))
