"""Gaussian diffusion strengthens one edge: the one along the force, by the shares of Eqs 7 and 8."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from reference import Colony as Reference
from reference import diffuse_gaussian, forces_of
from samples import colony_on, drawn, number_of, problem_on, random_grid

from acoexp import Grid
from acoexp.colony.pheromone import level
from acoexp.colony.problem import Problem
from acoexp.colony.state import Colony
from acoexp.colony.tabu import touch
from acoexp.strategies.diffusion.gaussian import Gaussian, shares

E, NE, N, NW, W, SW, S, SE = range(8)


def levels(colony: Colony) -> NDArray[np.float64]:
    """Return the pheromone, float64[cells, 8]."""
    return np.array([level(colony, edge) for edge in range(colony.stored.size)]).reshape(-1, 8)


def diffused(problem: Problem, cell: tuple[int, int], gamma: float = 0.5) -> dict[int, float]:
    """Let an ant stand on a cell: what the levels there are multiplied by, where that is not 1."""
    colony, part = colony_on(problem), Gaussian(gamma=gamma)
    before = levels(colony)
    part.kernel(colony, part.prepare(problem), 0, number_of(problem, cell), 8)
    grown = levels(colony) / before
    here = dict(enumerate(grown[number_of(problem, cell)].tolist()))
    grown[number_of(problem, cell)] = 1.0
    assert (grown == 1.0).all()  # nothing changes anywhere else
    return {direction: growth for direction, growth in here.items() if growth != 1.0}


def test_a_straight_neighbour_gets_1_minus_sqrt2_over_3_and_a_diagonal_one_a_third() -> None:
    straight, diagonal = shares().tolist()
    assert math.isclose(straight, 1.0 - math.sqrt(2.0) / 3.0, rel_tol=1e-15)
    assert math.isclose(diagonal, 1.0 / 3.0, rel_tol=1e-15)


@pytest.mark.parametrize(
    ("goal", "direction", "share"),
    [
        ((5, 9), E, 1.0 - math.sqrt(2.0) / 3.0),
        ((1, 9), NE, 1.0 / 3.0),
        ((0, 5), N, 1.0 - math.sqrt(2.0) / 3.0),
        ((0, 0), NW, 1.0 / 3.0),
        ((4, 0), W, 1.0 - math.sqrt(2.0) / 3.0),
        ((9, 1), SW, 1.0 / 3.0),
        ((9, 6), S, 1.0 - math.sqrt(2.0) / 3.0),
        ((9, 8), SE, 1.0 / 3.0),
    ],
)
def test_the_edge_towards_the_goal_grows_on_an_empty_map(
    goal: tuple[int, int], direction: int, share: float
) -> None:
    problem = problem_on(Grid(np.zeros((10, 10)), start=(5, 5), goal=goal))
    assert diffused(problem, (5, 5), gamma=0.3) == {direction: pytest.approx(1.0 + 0.3 * share, rel=1e-14)}


def test_nothing_diffuses_onto_an_obstacle() -> None:
    grid, _ = drawn(".... a#.b ....")
    weak = {"repulsion": 0.0}
    assert diffused(problem_on(grid, weak), (1, 0)) == {}
    assert diffused(problem_on(grid, weak), (0, 0)) != {}


@pytest.mark.parametrize(("moves", "grows"), [("free", True), ("no_squeeze", True), ("no_cut", False)])
def test_nothing_diffuses_along_a_move_that_the_maps_rule_forbids(moves: str, grows: bool) -> None:
    grid, _ = drawn("a#. ... ..b", moves)
    assert bool(diffused(problem_on(grid, {"repulsion": 0.0}), (0, 0))) == grows


def test_nothing_diffuses_where_no_force_acts() -> None:
    grid = Grid(np.zeros((5, 5)))
    assert diffused(problem_on(grid, {"attraction": 0.0}), (2, 2)) == {}


def test_obstacles_push_pheromone_away() -> None:
    grid, _ = drawn("...... a..#.b ......")
    assert set(diffused(problem_on(grid, {"repulsion": 0.0}), (1, 1))) == {E}
    assert set(diffused(problem_on(grid, {"repulsion": 1000.0}), (1, 1))) == {W}


def test_pheromone_diffuses_also_to_where_the_ant_has_been() -> None:
    problem, part = problem_on(Grid(np.zeros((3, 3)))), Gaussian(gamma=0.5)
    colony = colony_on(problem)
    touch(colony, number_of(problem, (1, 1)))
    part.kernel(colony, part.prepare(problem), 0, number_of(problem, (0, 0)), 8)
    assert level(colony, number_of(problem, (0, 0)) * 8 + SE) > 1.0


def test_weights_grow_by_the_power_alpha() -> None:
    problem, part = problem_on(Grid(np.zeros((3, 3))), alpha=2.0), Gaussian(gamma=0.3)
    colony = colony_on(problem)
    edge = number_of(problem, (0, 0)) * 8 + SE
    before = colony.weight[edge]
    part.kernel(colony, part.prepare(problem), 0, number_of(problem, (0, 0)), 8)
    assert math.isclose(colony.weight[edge] / before, 1.1**2)


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_on_every_cell_it_does_what_the_reference_does(moves: str) -> None:
    grid = random_grid(11, 9, 12, moves, density=0.35)
    problem, part, reference = problem_on(grid), Gaussian(gamma=0.4), Reference("pd", gamma=0.4)
    colony, own = colony_on(problem), part.prepare(problem)
    forces = forces_of(grid, reference)
    allowed = problem.allowed_edges()
    tau = {((int(r), int(c)), int(d)): 1.0 for r, c, d in np.argwhere(allowed)}
    for cell, force in forces.items():
        diffuse_gaussian(tau, cell, None, force, reference)
        part.kernel(colony, own, 0, number_of(problem, cell), 8)
    for (cell, direction), expected in tau.items():
        assert math.isclose(level(colony, number_of(problem, cell) * 8 + direction), expected, rel_tol=1e-12)
