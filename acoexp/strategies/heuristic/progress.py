"""eta = exp(strength * (d(cell) - d(target))), d the Euclidean distance to the goal, in cells.

One over the distance says less and less the farther the goal is: at 300 cells the ratio of two moves is 1.003.
Progress says the same at any distance. eta^beta is exp(strength * beta * progress).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.problem import Problem
from acoexp.parameters import parameter
from acoexp.strategies.heuristic.descent import descent
from acoexp.strategies.heuristic.targets import goal_distance
from acoexp.strategies.part import Heuristic


@dataclass(frozen=True, kw_only=True)
class Progress(Heuristic):
    """Prefers moves that bring an ant nearer to the goal as the crow flies, at any distance alike."""

    strength: float = parameter(2.0, "how much one cell of progress counts", minimum=0.0, maximum=100.0)

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8]."""
        return descent(goal_distance(problem.grid)[1:-1, 1:-1], self.strength)
