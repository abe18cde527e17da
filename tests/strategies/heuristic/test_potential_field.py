"""The heuristic potential_field: goal_distance, and how well a move follows the field's force."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from reference import Colony as Reference
from reference import desirability_of, forces_of
from samples import grids, problem_on, random_grid

from acoexp import Grid
from acoexp.strategies.heuristic.goal_distance import GoalDistance
from acoexp.strategies.heuristic.potential_field import ForceGuided


@given(grids(8))
def test_without_guidance_it_is_goal_distance(grid: Grid) -> None:
    problem = problem_on(grid)
    assert (ForceGuided(guidance=0.0, at_goal=5.0).eta(problem) == GoalDistance(at_goal=5.0).eta(problem)).all()


def test_a_move_counts_by_the_cosine_of_its_angle_to_the_force() -> None:
    problem = problem_on(Grid(np.zeros((7, 7)), start=(3, 1), goal=(3, 5)))  # the force points east
    guided, plain = ForceGuided(guidance=0.8).eta(problem), GoalDistance().eta(problem)
    half = math.sqrt(0.5)
    for direction, cosine in enumerate([1.0, half, 0.0, -half, -1.0, -half, 0.0, half]):
        assert math.isclose(guided[3, 1, direction] / plain[3, 1, direction], math.exp(0.8 * cosine))


def test_up_is_up() -> None:
    problem = problem_on(Grid(np.zeros((7, 7)), start=(5, 3), goal=(1, 3)))  # the force points north
    ratio = ForceGuided(guidance=1.0).eta(problem)[5, 3] / GoalDistance().eta(problem)[5, 3]
    assert ratio.argmax() == 2
    assert ratio.argmin() == 6


def test_the_move_to_the_goal_is_guided_too() -> None:
    problem = problem_on(Grid(np.zeros((3, 3)), start=(1, 0), goal=(1, 1)))
    assert math.isclose(ForceGuided(guidance=0.5, at_goal=10.0).eta(problem)[1, 0, 0], 10.0 * math.exp(0.5))


def test_where_no_force_acts_it_is_goal_distance() -> None:
    problem = problem_on(Grid(np.zeros((4, 4))), {"attraction": 0.0})
    assert (ForceGuided(guidance=3.0).eta(problem) == GoalDistance().eta(problem)).all()


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_on_every_edge_it_is_the_references(moves: str) -> None:
    grid, colony = random_grid(14, 9, 12, moves), Reference("pf", guidance=1.5, repulsion=60.0)
    eta = ForceGuided(guidance=1.5).eta(problem_on(grid, {"repulsion": 60.0}))
    for (cell, direction), expected in desirability_of(grid, colony, forces_of(grid, colony)).items():
        assert math.isclose(eta[cell][direction], expected, rel_tol=1e-12)
