"""The heuristic geodesic: how much of the shortest way to the goal a move saves."""

from __future__ import annotations

import math

import numpy as np
import pytest
from reference import moves_of
from samples import drawn, optimum_of, problem_on, random_grid

import acoexp
from acoexp import Grid
from acoexp.strategies.heuristic.geodesic import Geodesic


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_eta_is_the_exponential_of_how_much_of_the_way_a_move_saves(moves: str) -> None:
    grid = random_grid(13, 9, 12, moves)
    eta = Geodesic(strength=0.5).eta(problem_on(grid))
    ways = moves_of(grid)
    length = {cell: left(grid, cell) for cell in ways}
    for cell, leaving in ways.items():
        for direction, target in leaving.items():
            saved = length[cell] - length[target] if math.isfinite(length[cell]) else 0.0
            assert math.isclose(eta[cell][direction], math.exp(0.5 * saved), rel_tol=1e-9)


def left(grid: Grid, cell: tuple[int, int]) -> float:
    """Return the length of the shortest way from a cell to the goal; inf if there is none."""
    if cell == grid.goal:
        return 0.0
    try:
        pair = optimum_of(Grid(grid.obstacles, start=cell, goal=grid.goal, moves=grid.moves))
    except acoexp.MapError:
        return math.inf
    return pair[0] + pair[1] * math.sqrt(2.0)


def test_it_is_finite_everywhere() -> None:
    grid, _ = drawn("a.#. ..## ...b", "no_cut")  # a cell that no way leads from
    assert np.isfinite(Geodesic().eta(problem_on(grid))).all()
