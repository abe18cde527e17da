"""tau = (1 - rho) tau + sum of Q / L over the cycle's paths + e Q / L* over the run's best path.

The elitist ant system, Dorigo et al. 1996.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import lay
from acoexp.colony.problem import Problem
from acoexp.parameters import parameter
from acoexp.strategies.part import Update
from acoexp.strategies.update.ant_cycle import evaporate_and_lay


@compiled
def update(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    """Update as the ant system does, then let the elitist ants walk the best path again."""
    evaporate_and_lay(colony, final)
    if best.length[0] < np.inf:
        lay(colony, best, 0, own[0] * colony.q / best.length[0])


@dataclass(frozen=True, kw_only=True)
class Elitist(Update):
    """Every ant lays Q / L, and a number of elitist ants lay it on the run's best path (Dorigo et al. 1996)."""

    elitists: int = parameter(
        8, "elitist ants e, that walk the best path again in each cycle", minimum=0, maximum=100_000
    )

    kernel = staticmethod(update)

    def prepare(self, problem: Problem) -> tuple[float]:
        """Hand the number over."""
        return (float(self.elitists),)
