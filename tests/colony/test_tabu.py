"""Tabu: a move is open if the map allows it and the ant has not been where it leads."""

from __future__ import annotations

import numpy as np
import pytest
from reference import moves_of
from samples import colony_on, drawn, number_of, problem_on, trails_of

from acoexp.colony.changes import PATCH
from acoexp.colony.tabu import forget, is_open, touch

E, NE, N, NW, W, SW, S, SE = range(8)
DRAWING = "a... .#.. ...b"


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_before_an_ant_walks_all_moves_that_the_map_allows_are_open(moves: str) -> None:
    grid, _ = drawn(DRAWING, moves)
    problem = problem_on(grid)
    colony = colony_on(problem)
    for cell, allowed in moves_of(grid).items():
        number = number_of(problem, cell)
        assert [d for d in range(8) if is_open(colony, number, d)] == sorted(allowed)


def test_a_cell_that_was_touched_is_closed_from_every_side() -> None:
    grid, _ = drawn("a.. ... ..b")
    problem = problem_on(grid)
    colony, centre = colony_on(problem), number_of(problem, (1, 1))
    touch(colony, centre)
    for direction, offset in enumerate(colony.offsets):
        assert not is_open(colony, centre - offset, direction)
    assert is_open(colony, number_of(problem, (0, 0)), E)


def test_the_next_ant_finds_every_cell_open() -> None:
    grid, _ = drawn(DRAWING, "free")
    problem = problem_on(grid)
    colony = colony_on(problem)
    walk = [E, SE, SE, E]
    cell = colony.start
    for move in [*walk, None]:
        touch(colony, cell)
        cell = cell + colony.offsets[move] if move is not None else cell
    given_up = np.array([number_of(problem, (2, 0)), 0], dtype=np.int32)
    touch(colony, given_up[0])
    assert (colony.untouched == 0.0).sum() == 6
    forget(colony, trails_of(colony, walk), 0, given_up, 1)
    assert (colony.untouched == 1.0).all()


def test_what_an_ant_may_have_changed_on_its_way_is_noted_when_it_leaves() -> None:
    grid, _ = drawn(DRAWING, "free")
    problem = problem_on(grid)
    colony, given_up = colony_on(problem), np.array([number_of(problem, (2, 0))], dtype=np.int32)
    forget(colony, trails_of(colony, [E, SE, SE, E]), 0, given_up, 1)
    been = [number_of(problem, cell) for cell in [(0, 0), (0, 1), (1, 2), (2, 3), (2, 4), (2, 0)]]
    assert set(colony.is_changed.nonzero()[0].tolist()) == {cell * 8 // PATCH for cell in been}
