"""Where pheromone has gathered, on maps and levels of which it is known."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from acoexp_paper.trials.concentration import (
    CYCLES,
    ENTROPY,
    ON_SHORTEST,
    concentration,
    moves_of_shortest_paths,
    with_concentration,
)
from small import run_trials

from acoexp.compare.measures import measured
from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver

CORNER = Grid(np.array([[0, 0, 0], [1, 1, 0], [1, 1, 0]]), moves="no_cut")


def test_one_shortest_path_is_its_moves() -> None:
    moves = {tuple(move) for move in np.argwhere(moves_of_shortest_paths(CORNER)).tolist()}
    right, down = DIRECTIONS.index((0, 1)), DIRECTIONS.index((1, 0))
    assert moves == {(0, 0, right), (0, 1, right), (0, 2, down), (1, 2, down)}


def test_all_shortest_paths_count() -> None:
    grid = load_map("fig13")
    on_shortest = moves_of_shortest_paths(grid)
    for (row, col), (next_row, next_col) in pairwise(grid.shortest_path.tolist()):
        assert on_shortest[row, col, DIRECTIONS.index((next_row - row, next_col - col))]
    assert on_shortest.sum() > len(grid.shortest_path) - 1


def test_pheromone_on_one_move_is_all_concentrated_and_even_pheromone_not_at_all() -> None:
    on_shortest = moves_of_shortest_paths(CORNER)
    one, even = np.zeros((3, 3, 8)), np.full((3, 3, 8), 0.3)
    one[0, 0, DIRECTIONS.index((0, 1))] = 5.0
    even[0, 0, :4] = 0.0
    assert concentration(one + 1e-300, on_shortest) == pytest.approx((1.0, 0.0))
    share, entropy = concentration(even, on_shortest)
    assert entropy == pytest.approx(1.0)
    assert share == pytest.approx((on_shortest & (even > 0)).sum() / (even > 0).sum())


@pytest.mark.slow_without_jit
def test_a_trials_features_are_those_of_its_pheromone_after_the_last_of_the_cycles() -> None:
    grid, settings = load_map("fig13"), resolve("aco", {"iterations": 12, "ants": 5})
    plain = measured("aco", grid, run_trials(settings, grid, parse_seeds("0-2")))
    found = with_concentration(plain, grid, settings)
    assert found.features.keys() - plain.features.keys() == {ON_SHORTEST, ENTROPY}
    ten = Solver(grid, resolve("aco", {"iterations": CYCLES[-1], "ants": 5}))
    last = concentration(np.nan_to_num(ten.pheromone(2)), moves_of_shortest_paths(grid))
    assert (found.features[ON_SHORTEST][2], found.features[ENTROPY][2]) == last
    assert ((found.features[ENTROPY] > 0.0) & (found.features[ENTROPY] < 1.0)).all()
