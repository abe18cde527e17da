"""The heuristic progress: how much nearer to the goal a move leads, at any distance alike."""

from __future__ import annotations

import math

import numpy as np
import pytest
from reference import moves_of
from samples import problem_on, random_grid

from acoexp import Grid
from acoexp.strategies.heuristic.progress import Progress


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
@pytest.mark.parametrize("strength", [0.0, 0.5, 2.0])
def test_eta_is_the_exponential_of_how_much_nearer_to_the_goal_a_move_leads(strength: float, moves: str) -> None:
    grid = random_grid(13, 9, 12, moves)
    eta = Progress(strength=strength).eta(problem_on(grid))
    for cell, ways in moves_of(grid).items():
        for direction, target in ways.items():
            progress = math.dist(cell, grid.goal) - math.dist(target, grid.goal)
            assert math.isclose(eta[cell][direction], math.exp(strength * progress), rel_tol=1e-12)


def test_far_from_the_goal_it_says_as_much_as_near_it() -> None:
    eta = Progress().eta(problem_on(Grid(np.zeros((1, 1000)), start=(0, 0), goal=(0, 999))))
    assert math.isclose(eta[0, 1, 0] / eta[0, 1, 4], math.exp(4.0))
    assert math.isclose(eta[0, 1, 0], eta[0, 900, 0])
