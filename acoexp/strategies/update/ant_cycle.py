"""tau = (1 - rho) tau + sum of Q / L over the ants that walked the edge (Ant-Cycle; Liu et al. 2017, Eq. 18)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import evaporate, lay
from acoexp.strategies.part import Update


@compiled
def evaporate_and_lay(colony: Any, trails: Any) -> None:
    """Evaporate once, then let every ant that arrived lay Q / L on its path."""
    evaporate(colony, colony.rho)
    for ant in range(colony.ants):
        if trails.length[ant] < np.inf:
            lay(colony, trails, ant, colony.q / trails.length[ant])


@compiled
def update(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    """Update with the paths as they were walked."""
    evaporate_and_lay(colony, raw)


@dataclass(frozen=True, kw_only=True)
class AntCycle(Update):
    """Every ant that arrives lays Q / L on the path it walked (Eq. 18)."""

    kernel = staticmethod(update)
