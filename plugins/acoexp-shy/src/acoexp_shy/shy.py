"""Each edge keeps the share ``keep`` of its pheromone when an ant has walked it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import multiply
from acoexp.colony.problem import Problem
from acoexp.colony.state import NO_WAY_HERE
from acoexp.parameters import parameter
from acoexp.strategies import Diffusion
from acoexp_shy.walked import edge_behind


@compiled
def weaken(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Weaken the edge just walked."""
    if came != NO_WAY_HERE:
        keep, keep_to_alpha = own
        multiply(colony, edge_behind(colony, cell, came), keep, keep_to_alpha)


@dataclass(frozen=True, kw_only=True)
class Shy(Diffusion):
    """Weakens each edge as it is walked, so that the next ant rather looks elsewhere."""

    contract: ClassVar[int] = 1

    keep: float = parameter(0.99, "share of an edge's pheromone that stays", minimum=0.0, maximum=1.0)

    kernel = staticmethod(weaken)

    def prepare(self, problem: Problem) -> tuple[float, float]:
        """Return keep and keep^alpha, so that no power is computed at a step."""
        return self.keep, self.keep**problem.settings.alpha
