"""Pheromone without a direction: ants lay it on both ways of every edge they walked.

The paper's edges (i, j) may be those of a graph whose edges have none.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import deposit
from acoexp.strategies.part import Update
from acoexp.strategies.update.ant_cycle import evaporate_and_lay


@compiled
def _both_ways(colony: Any, trails: Any) -> None:
    """Update as Eq. 18 has it, then lay the same on the way back."""
    evaporate_and_lay(colony, trails)
    for ant in range(colony.ants):
        if trails.length[ant] < np.inf:
            cell = colony.start
            for step in range(trails.steps[ant]):
                move = trails.moves[np.uintp(ant), np.uintp(step)]
                cell += colony.offsets[np.uintp(move)]
                deposit(colony, np.uintp(cell * 8 + (move ^ 4)), colony.q / trails.length[ant])


@compiled
def _with_raw(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    _both_ways(colony, raw)


@compiled
def _with_both(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    _both_ways(colony, raw)
    _both_ways(colony, final)


@dataclass(frozen=True, kw_only=True)
class UndirectedAntCycle(Update):
    """Eq. 18 on edges without a direction."""

    kernel = staticmethod(_with_raw)


@dataclass(frozen=True, kw_only=True)
class UndirectedDualAntCycle(Update):
    """Eqs 18 and 19 on edges without a direction."""

    kernel = staticmethod(_with_both)
