"""What is worked out before the first ant: arrays as kernels index them."""

from __future__ import annotations

import numpy as np
import pytest
from reference import moves_of
from samples import problem_on, random_grid


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_shared_by_target_all_edges_into_a_cell_have_the_mean_of_their_values(moves: str) -> None:
    grid = random_grid(4, 7, 9, moves, density=0.3)
    values = np.random.default_rng(0).uniform(size=(7, 9, 8))
    shared = problem_on(grid).shared_by_target(values)
    edges = {(cell, d): target for cell, ways in moves_of(grid).items() for d, target in ways.items()}
    for (cell, d), target in edges.items():
        into = [values[(*other, e)] for (other, e), goal in edges.items() if goal == target]
        assert shared[(*cell, d)] == pytest.approx(np.mean(into))


def test_the_allowed_moves_of_some_rows_are_those_of_the_map() -> None:
    grid = random_grid(4, 7, 9, "no_cut", density=0.3)
    allowed = problem_on(grid).allowed_edges()
    assert {(cell, d) for cell, ways in moves_of(grid).items() for d in ways} == {
        ((row, col), d) for row, col, d in np.argwhere(allowed).tolist()
    }
    assert np.array_equal(problem_on(grid).allowed_edges(slice(2, 5)), allowed[2:5])


def test_kernels_find_a_cell_and_its_edges_under_its_number() -> None:
    problem = problem_on(random_grid(4, 7, 9, "free"))
    per_cell, per_edge = np.arange(7 * 9).reshape(7, 9), np.arange(7 * 9 * 8).reshape(7, 9, 8)
    number = problem.cell((2, 5))
    assert problem.per_cell(per_cell, border=-1)[number] == per_cell[2, 5]
    assert problem.per_edge(per_edge, border=-1)[number * 8 : number * 8 + 8].tolist() == per_edge[2, 5].tolist()


def test_around_the_map_lies_a_border_so_that_each_neighbour_is_there_to_be_looked_at() -> None:
    problem = problem_on(random_grid(4, 7, 9, "free"))
    laid_out = problem.per_cell(np.ones((7, 9)), border=-1).reshape(9, 11)
    assert (np.concatenate([laid_out[0], laid_out[-1], laid_out[:, 0], laid_out[:, -1]]) == -1).all()
    assert (laid_out[1:-1, 1:-1] == 1).all()
