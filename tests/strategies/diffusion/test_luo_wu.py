"""Luo and Wu's diffusion strengthens the two edges beside the force, each in proportion to its nearness."""

from __future__ import annotations

import math

import numpy as np
import pytest
from reference import Cell, diffuse_luo_wu, forces_of
from reference import Colony as Reference
from samples import colony_on, drawn, number_of, problem_on, random_grid

from acoexp import Grid
from acoexp.colony.pheromone import level, set_level
from acoexp.colony.problem import Problem
from acoexp.strategies.diffusion.luo_wu import LuoWu

E, NE, N, NW, W, SW, S, SE = range(8)
STRAIGHT, DIAGONAL = 1.0 - math.sqrt(2.0) / 3.0, 1.0 / 3.0
STEEP = math.atan2(1.0, 2.0) / (math.pi / 4)
"""Sectors from a straight direction to a goal two cells along and one aside: nearer to the diagonal."""


def diffused(problem: Problem, cell: Cell, levels: dict[int, float] | None = None) -> dict[int, float]:
    """Let an ant stand on a cell, gamma = 0.3: what the levels there gain, where that is not 0.

    They are 1 before, but for those given.
    """
    colony, part = colony_on(problem), LuoWu(gamma=0.3)
    edges = number_of(problem, cell) * 8 + np.arange(8)
    for direction, amount in (levels or {}).items():
        set_level(colony, edges[direction], amount)
    before = [level(colony, edge) for edge in edges]
    part.kernel(colony, part.prepare(problem), 0, number_of(problem, cell), 8)
    gains = [level(colony, edge) - old for edge, old in zip(edges, before, strict=True)]
    return {direction: gain for direction, gain in enumerate(gains) if abs(gain) > 1e-12}


@pytest.mark.parametrize(
    ("goal", "straight", "diagonal"),
    [
        ((4, 7), E, NE),
        ((3, 6), N, NE),
        ((3, 4), N, NW),
        ((4, 3), W, NW),
        ((6, 3), W, SW),
        ((7, 4), S, SW),
        ((7, 6), S, SE),
        ((6, 7), E, SE),
    ],
)
def test_the_two_directions_beside_the_force_share_in_proportion_to_nearness(
    goal: tuple[int, int], straight: int, diagonal: int
) -> None:
    problem = problem_on(Grid(np.zeros((10, 10)), start=(5, 5), goal=goal))
    assert diffused(problem, (5, 5)) == {
        straight: pytest.approx(0.3 * STRAIGHT * (1.0 - STEEP)),
        diagonal: pytest.approx(0.3 * DIAGONAL * STEEP),
    }


@pytest.mark.parametrize(("goal", "direction", "share"), [((5, 9), E, STRAIGHT), ((9, 9), SE, DIAGONAL)])
def test_a_force_right_along_a_direction_strengthens_that_alone(
    goal: tuple[int, int], direction: int, share: float
) -> None:
    problem = problem_on(Grid(np.zeros((10, 10)), start=(5, 5), goal=goal))
    assert diffused(problem, (5, 5)) == {direction: pytest.approx(0.3 * share)}


def test_what_diffuses_is_the_pheromone_of_the_nearer_edge() -> None:
    problem = problem_on(Grid(np.zeros((10, 10)), start=(5, 5), goal=(4, 7)))
    assert diffused(problem, (5, 5), {E: 7.0, NE: 100.0}) == {
        E: pytest.approx(100.0 * 0.3 * STRAIGHT * (1.0 - STEEP)),
        NE: pytest.approx(100.0 * 0.3 * DIAGONAL * STEEP),
    }


@pytest.mark.parametrize(
    ("drawing", "gains"),
    [
        ("... .#b a..", {E: 7.0 * STRAIGHT * (1.0 - STEEP)}),
        ("... ..b a#.", {NE: 9.0 * DIAGONAL * STEEP}),
        ("... .#b a#.", {}),
    ],
    ids=["the nearer one", "the other one", "both"],
)
def test_a_move_that_is_closed_gets_nothing_and_the_open_one_is_its_own_source(
    drawing: str, gains: dict[int, float]
) -> None:
    grid, named = drawn(drawing)
    found = diffused(problem_on(grid, {"repulsion": 0.0}), named["a"], {E: 7.0, NE: 9.0})
    assert found == {direction: pytest.approx(0.3 * gain) for direction, gain in gains.items()}


def test_nothing_diffuses_where_no_force_acts() -> None:
    assert diffused(problem_on(Grid(np.zeros((5, 5))), {"attraction": 0.0}), (2, 2)) == {}


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_on_every_cell_it_does_what_the_reference_does(moves: str) -> None:
    grid = random_grid(12, 9, 12, moves, density=0.35)
    problem, part, reference = problem_on(grid), LuoWu(gamma=0.4), Reference("pf", gamma=0.4)
    colony, own = colony_on(problem), part.prepare(problem)
    tau = {((int(r), int(c)), int(d)): 1.0 for r, c, d in np.argwhere(problem.allowed_edges())}
    for cell, direction in tau:
        tau[cell, direction] = 1.0 + direction
        set_level(colony, number_of(problem, cell) * 8 + direction, 1.0 + direction)
    for cell, force in forces_of(grid, reference).items():
        diffuse_luo_wu(tau, cell, None, force, reference)
        part.kernel(colony, own, 0, number_of(problem, cell), 8)
    for (cell, direction), expected in tau.items():
        assert math.isclose(level(colony, number_of(problem, cell) * 8 + direction), expected, rel_tol=1e-12)
