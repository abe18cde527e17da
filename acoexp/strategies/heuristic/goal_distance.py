"""eta = 1 / distance from the target cell to the goal, the convention of the grid-ACO literature."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.problem import Problem
from acoexp.grid.moves import DIRECTIONS
from acoexp.parameters import parameter
from acoexp.strategies.part import Heuristic


@dataclass(frozen=True, kw_only=True)
class GoalDistance(Heuristic):
    """Prefers moves to cells near the goal: one over the Euclidean distance from there, in cells."""

    at_goal: float = parameter(100.0, "eta of a move to the goal itself, where the distance is 0", above=0.0)

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8]."""
        row, col = np.indices(problem.grid.shape)[..., None]
        down, right = np.transpose(DIRECTIONS)
        goal_row, goal_col = problem.grid.goal
        distance = np.hypot(row + down - goal_row, col + right - goal_col)
        return np.where(distance == 0.0, self.at_goal, 1.0 / np.maximum(distance, 1.0))
