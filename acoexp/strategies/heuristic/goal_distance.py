"""eta = 1 / distance from the target cell to the goal, the convention of the grid-ACO literature."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.problem import Problem
from acoexp.parameters import parameter
from acoexp.strategies.heuristic.targets import at_targets, goal_distance
from acoexp.strategies.part import Heuristic


@dataclass(frozen=True, kw_only=True)
class GoalDistance(Heuristic):
    """Prefers moves to cells near the goal: one over the Euclidean distance from there, in cells."""

    at_goal: float = parameter(100.0, "eta of a move to the goal itself, where the distance is 0", above=0.0)

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8]."""
        distance = goal_distance(problem.grid)
        return at_targets(np.where(distance == 0.0, self.at_goal, 1.0 / np.maximum(distance, 1.0)))
