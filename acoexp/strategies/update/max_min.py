"""MAX-MIN ant system: only the best path gets pheromone, and every level stays in [tau_min, tau_max].

tau_max = Q / (rho L*), tau_min = tau_max (1 - p^(1/n)) / ((c - 1) p^(1/n)), p the probability that a converged
colony walks the best path, n its moves, c the moves that an ant chooses from (Stuetzle and Hoos 1997, 2000).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import clamp, evaporate, lay
from acoexp.colony.problem import Problem
from acoexp.errors import SettingsError
from acoexp.parameters import parameter
from acoexp.strategies.part import Update

CHOICES = 4.0
"""c: half of the eight moves, as Stuetzle and Hoos take half of the cities."""

LOWEST_RHO = 1e-6
"""Where hardly anything evaporates the limits lie so high that nothing an ant lays would be seen."""


@compiled
def update(colony: Any, own: Any, raw: Any, final: Any, best: Any) -> None:
    """Evaporate, let the best ant lay, and bring all levels between the limits that follow from the best path."""
    evaporate(colony, colony.rho)
    if best.length[0] == np.inf:
        return
    use_run, p_best = own
    shortest = _shortest(final)
    if use_run:
        lay(colony, best, 0, colony.q / best.length[0])
    elif shortest >= 0:
        lay(colony, final, shortest, colony.q / final.length[shortest])
    highest = colony.q / (colony.rho * best.length[0])
    root = p_best ** (1.0 / best.steps[0])
    clamp(colony, min(highest, highest * (1.0 - root) / ((CHOICES - 1.0) * root)), highest)


@compiled
def _shortest(trails: Any) -> Any:
    """Return the ant with the cycle's shortest path, -1 if all are lost."""
    shortest, found = np.inf, -1
    for ant in range(trails.length.size):
        if trails.length[ant] < shortest:
            shortest, found = trails.length[ant], ant
    return found


@dataclass(frozen=True, kw_only=True)
class MaxMin(Update):
    """Only the best path gets pheromone, and levels have limits that follow from it (Stuetzle and Hoos 1997)."""

    p_best: float = parameter(
        0.05, "probability that a converged colony walks the best path", above=0.0, maximum=1.0
    )
    best: str = parameter(
        "cycle", "whose best path gets pheromone: the cycle's or the run's", choices=("cycle", "run")
    )

    kernel = staticmethod(update)

    def prepare(self, problem: Problem) -> tuple[bool, float]:
        """Hand the parameters over.

        Raises:
            SettingsError: for a rho from which no limits follow.
        """
        rho = problem.settings.rho
        if rho < LOWEST_RHO:
            raise SettingsError(
                f"rho: expected a number from {LOWEST_RHO:g} to 1 with update=max_min, whose limits are "
                f"Q / (rho L*); got {rho:g}"
            )
        return (self.best == "run", self.p_best)

    def initial(self, problem: Problem) -> float:
        """Begin at tau_max of a path as long as the straight line to the goal: no path's limit is higher."""
        settings = problem.settings
        (row, col), (goal_row, goal_col) = problem.grid.start, problem.grid.goal
        line = float(np.hypot(goal_row - row, goal_col - col))
        return settings.q / (settings.rho * line)
