"""What is worked out before the first ant: arrays as kernels index them."""

from __future__ import annotations

import numpy as np
import pytest
from reference import moves_of
from samples import problem_on, random_grid


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut"])
def test_shared_by_target_all_edges_into_a_cell_have_the_mean_of_their_values(moves: str) -> None:
    grid = random_grid(4, 7, 9, moves, density=0.3)
    values = np.random.default_rng(0).uniform(size=(7, 9, 8))
    shared = problem_on(grid).shared_by_target(values)
    edges = {(cell, d): target for cell, ways in moves_of(grid).items() for d, target in ways.items()}
    for (cell, d), target in edges.items():
        into = [values[(*other, e)] for (other, e), goal in edges.items() if goal == target]
        assert shared[(*cell, d)] == pytest.approx(np.mean(into))
