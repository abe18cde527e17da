"""What the updates of published variants are held to: one update by hand, and a colony that learns."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from samples import colony_on, drawn, number_of, problem_on, trails_of

import acoexp
from acoexp.colony.changes import refresh
from acoexp.colony.pheromone import level

GRID, _ = drawn("a.. ... ..b")


@pytest.fixture(scope="session")
def updated() -> Callable[..., NDArray[np.float64]]:
    """Return what tells the pheromone after one update, float64[3, 3, 8]: Q = 6, tau0 = 2.

    It takes the rule, then the ways of the cycle's ants on an empty map of 3 x 3 cells, None for a lost one; and
    ``best``, the run's best way so far.
    """

    def levels(rule: Any, *walks: list[int] | None, best: list[int] | None, rho: float = 0.25) -> Any:
        problem = problem_on(GRID, ants=len(walks), rho=rho, q=6.0, tau0=2.0, alpha=1.0)
        colony = colony_on(problem)
        trails, best_trails = trails_of(colony, *walks), trails_of(colony, best, best)
        rule.kernel(colony, rule.prepare(problem), trails, trails, best_trails)
        refresh(colony)
        cells = [number_of(problem, (row, col)) for row in range(3) for col in range(3)]
        return np.array([[level(colony, cell * 8 + d) for d in range(8)] for cell in cells]).reshape(3, 3, 8)

    return levels


@pytest.fixture(scope="session")
def learns() -> Callable[[str], bool]:
    """Return what tells whether what a preset converges to is better than what its first cycles find."""

    def better_at_last(algo: str) -> bool:
        results = acoexp.solve_many("fig13", algo, range(20), iterations=100)
        assert {result.algo for result in results} == {algo}
        return bool(np.nanmean([r.curve[-10:] for r in results]) < np.nanmean([r.curve[:3] for r in results]))

    return better_at_last
