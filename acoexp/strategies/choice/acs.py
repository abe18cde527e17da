"""With probability q0 the heaviest open move, else the roulette; the edge just taken decays towards tau0 (ACS).

tau = (1 - xi) tau + xi tau0 on that edge: the pseudo-random proportional rule and the local update of Dorigo and
Gambardella 1997.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import level, set_level
from acoexp.colony.problem import Problem
from acoexp.colony.random import uniform
from acoexp.colony.state import LOST
from acoexp.colony.tabu import is_open
from acoexp.parameters import parameter
from acoexp.strategies.choice.roulette import spin
from acoexp.strategies.part import Choice


@compiled
def choose(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    """Choose, and let the edge decay."""
    q0, xi = own
    move = _heaviest(colony, cell) if uniform(colony.random) < q0 else spin(colony, own, ant, cell, came)
    if move != LOST:
        edge = cell * 8 + move
        set_level(colony, edge, (1.0 - xi) * level(colony, edge) + xi * colony.tau0)
    return move


@compiled
def _heaviest(colony: Any, cell: Any) -> Any:
    """Return the open move of the largest weight, the first of several; LOST if none is open."""
    found, largest = LOST, -1.0
    for direction in range(8):
        if is_open(colony, cell, direction) and colony.weight[cell * 8 + direction] > largest:
            found, largest = direction, colony.weight[cell * 8 + direction]
    return found


@dataclass(frozen=True, kw_only=True)
class AntColonySystem(Choice):
    """Mostly takes the heaviest move, and weakens the edge it takes (ACS; Dorigo and Gambardella 1997)."""

    q0: float = parameter(0.9, "probability to take the heaviest move", minimum=0.0, maximum=1.0)
    xi: float = parameter(0.1, "decay of the edge just taken towards tau0", minimum=0.0, maximum=1.0)

    kernel = staticmethod(choose)

    def prepare(self, problem: Problem) -> tuple[float, float]:
        """Hand the parameters over."""
        return (self.q0, self.xi)
