"""The heuristic goal_distance: one over the distance from a move's target to the goal."""

from __future__ import annotations

import math

import numpy as np
import pytest
from reference import Colony as Reference
from reference import desirability_of, forces_of
from samples import problem_on, random_grid

from acoexp import Grid
from acoexp.errors import SettingsError
from acoexp.parameters import build
from acoexp.strategies.heuristic.goal_distance import GoalDistance

E, NE, N, NW, W, SW, S, SE = range(8)


def test_eta_is_one_over_the_distance_from_the_target_to_the_goal() -> None:
    eta = GoalDistance().eta(problem_on(Grid(np.zeros((6, 6)), goal=(1, 4))))
    assert eta.shape == (6, 6, 8)
    for direction, squared in {E: 4, NE: 5, N: 10, NW: 17, W: 16, SW: 17, S: 10, SE: 5}.items():
        assert math.isclose(eta[1, 1, direction], 1.0 / math.sqrt(squared))


@pytest.mark.parametrize("at_goal", [100.0, 7.0, 1e-3])
def test_a_move_to_the_goal_itself_has_the_declared_eta(at_goal: float) -> None:
    eta = GoalDistance(at_goal=at_goal).eta(problem_on(Grid(np.zeros((5, 5)), goal=(2, 2))))
    into = {(2, 1): E, (3, 1): NE, (3, 2): N, (3, 3): NW, (2, 3): W, (1, 3): SW, (1, 2): S, (1, 1): SE}
    for cell, direction in into.items():
        assert eta[cell][direction] == at_goal
    assert (eta == at_goal).sum() == len(into)


@pytest.mark.parametrize("at_goal", [0.0, -1.0, math.inf, math.nan])
def test_an_eta_at_the_goal_that_is_none_is_refused(at_goal: float) -> None:
    with pytest.raises(SettingsError, match="at_goal"):
        build(GoalDistance, {"at_goal": at_goal})


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_on_every_edge_it_is_the_references(moves: str) -> None:
    grid, colony = random_grid(13, 9, 12, moves), Reference("aco", at_goal=7.0)
    eta = GoalDistance(at_goal=7.0).eta(problem_on(grid))
    for (cell, direction), expected in desirability_of(grid, colony, forces_of(grid, colony)).items():
        assert math.isclose(eta[cell][direction], expected, rel_tol=1e-14)
