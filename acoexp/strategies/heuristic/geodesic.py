"""eta = exp(strength * (d(cell) - d(target))), d the exact length of the shortest way to the goal.

This hands over the answer: an ant that follows it alone walks a shortest path. It tells what a colony can gain at
most from its heuristic, and serves where the way is known and something else is to be optimised.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.problem import Problem
from acoexp.parameters import parameter
from acoexp.strategies.heuristic.targets import at_targets
from acoexp.strategies.part import Heuristic


@dataclass(frozen=True, kw_only=True)
class Geodesic(Heuristic):
    """Prefers moves along a shortest way, which it is told: it hands over the answer."""

    strength: float = parameter(2.0, "how much one cell of progress counts", minimum=0.0, maximum=100.0)

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8]; 1 where no way leads to the goal."""
        distance = np.pad(problem.distance, 1, constant_values=np.inf)
        here, factor = distance[1:-1, 1:-1, None], at_targets(distance)
        known = np.isfinite(here) & np.isfinite(factor)
        np.subtract(here, factor, where=known, out=factor)
        factor[~known] = 0.0
        factor *= self.strength
        return np.exp(factor, out=factor)
