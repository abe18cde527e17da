"""tau = (1 - rho) tau + rho Q / L* on the edges of the run's best path, and nowhere else (ACS's global update).

Dorigo and Gambardella 1997.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import level, set_level
from acoexp.strategies.part import Update


@compiled
def update(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    """Bring the best path's edges nearer to Q / L*."""
    if best.length[0] == np.inf:
        return
    cell = colony.start
    for step in range(best.steps[0]):
        edge = cell * 8 + best.moves[0, step]
        set_level(colony, edge, (1.0 - colony.rho) * level(colony, edge) + colony.rho * colony.q / best.length[0])
        cell += colony.offsets[best.moves[0, step]]


@dataclass(frozen=True, kw_only=True)
class GlobalBest(Update):
    """Only the run's best path evaporates and gets pheromone (ACS; Dorigo and Gambardella 1997)."""

    kernel = staticmethod(update)
