"""p(move) = tau^alpha * eta^beta * exp(-penalty * turn), turn the angle to the last move in eighths of a circle.

A penalty for turning, as in many published variants for robots, which are slow in bends; the first move of an
ant is free.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.problem import Problem
from acoexp.colony.random import uniform
from acoexp.colony.state import LOST, NO_WAY_HERE
from acoexp.colony.tabu import is_open
from acoexp.parameters import parameter
from acoexp.strategies.choice.roulette import spin
from acoexp.strategies.part import Choice


class OwnState(NamedTuple):
    """Attributes: factor float64[8, 8], by the direction come from and the move; weights float64[8], room."""

    factor: NDArray[np.float64]
    weights: NDArray[np.float64]


@compiled
def choose(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    """Spin the roulette with weights that turning makes smaller; without them where all underflow."""
    if came == NO_WAY_HERE:
        return spin(colony, own, ant, cell, came)
    total = 0.0
    for move in range(8):
        own.weights[move] = 0.0
        if is_open(colony, cell, move):
            own.weights[move] = colony.weight[cell * 8 + move] * own.factor[came, move]
        total += own.weights[move]
    if total == 0.0:
        return spin(colony, own, ant, cell, came)
    ball = uniform(colony.random) * total
    last = LOST
    for move in range(8):
        if own.weights[move] > 0.0:
            last = move
            if ball < own.weights[move]:
                return move
            ball -= own.weights[move]
    return last


@dataclass(frozen=True, kw_only=True)
class Turning(Choice):
    """The roulette with a penalty for turning."""

    penalty: float = parameter(
        0.5, "log of the factor by which an eighth of a turn is less likely", minimum=0.0, maximum=50.0
    )

    kernel = staticmethod(choose)

    def prepare(self, problem: Problem) -> OwnState:
        """Table the factor by direction."""
        turn = np.abs(np.arange(8)[:, None] - np.arange(8))
        factor = np.exp(-self.penalty * np.minimum(turn, 8 - turn))
        factor.flags.writeable = False
        return OwnState(factor, np.zeros(8))
