"""eta = (1 / distance to the goal) * exp(guidance * cos(angle between the move and the field's force)).

Part of the reconstruction of ACO-PF (Luo and Wu 2010), whose formulas no public source gives: that the
resultant force of the potential field guides the ants as part of the heuristic is known, the form is ours.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.problem import Problem
from acoexp.grid.moves import DIRECTIONS
from acoexp.parameters import parameter
from acoexp.strategies.heuristic.goal_distance import GoalDistance


@dataclass(frozen=True, kw_only=True)
class ForceGuided(GoalDistance):
    """Prefers moves towards the goal and along the potential field's force; a reconstruction of Luo and Wu."""

    guidance: float = parameter(
        0.1, "how much the force's direction counts; 0 is goal_distance", minimum=0.0, maximum=10.0
    )

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        """Return eta, float64[rows, cols, 8]."""
        down, right = np.transpose(DIRECTIONS)
        ahead = np.stack([right, -down]) / np.hypot(down, right)
        force = problem.field.force
        strength = np.hypot(force[..., 0], force[..., 1])[..., None]
        factor: NDArray[np.float64] = force @ ahead  # its cosine once it is divided by the strength
        factor /= np.where(strength == 0.0, 1.0, strength)
        factor *= self.guidance
        np.exp(factor, out=factor)
        factor *= super().eta(problem)
        return factor
