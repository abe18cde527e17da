"""Trails: a path as directions and as cells is the same path, and nothing but a path is taken over."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from reference import Path, length_of, pair_of
from samples import colony_on, drawn, grids, is_way, optimum_of, problem_on, trails_of

from acoexp import Grid
from acoexp.colony.trails import copy_trail, measure, read_cells, write_cells
from acoexp.trial.workspace import new_trails

GRID, AT = drawn("""
    a.#.
    .#.b
    ....
""")
"""Way from a to b under the rule no_squeeze; (0, 1) to (1, 2) squeezes through."""

WAY = [(0, 0), (1, 0), (2, 1), (2, 2), (1, 3)]


def numbers(grid: Grid, path: Path) -> list[int]:
    """Return a path's cells as numbers on the bordered map."""
    return [problem_on(grid).cell(cell) for cell in path]


def written(cells: list[int]) -> list[int] | None:
    """Write cells into a trail: what is read back from it, None if they were refused."""
    colony = colony_on(problem_on(GRID))
    trails, back = new_trails(2, colony.allowed.size), np.full(colony.allowed.size, -7, dtype=np.int32)
    given = np.array(cells, dtype=np.int32)
    with np.errstate(over="ignore"):  # differences of cell numbers may wrap around when nothing is compiled
        accepted = write_cells(colony, given, len(cells), trails, 1)
    return back[: read_cells(colony, trails, 1, back)].tolist() if accepted else None


@settings(deadline=None)
@given(grids(12))
def test_a_path_written_as_cells_reads_back_the_same(grid: Grid) -> None:
    colony, path = colony_on(problem_on(grid)), [(r, c) for r, c in grid.shortest_path.tolist()]
    assert is_way(grid, path)
    trails = new_trails(1, colony.allowed.size)
    cells = np.array(numbers(grid, path), dtype=np.int32)
    assert write_cells(colony, cells, len(cells), trails, 0)
    straight, diagonal = pair_of(path)
    assert (trails.straight[0], trails.steps[0]) == (straight, straight + diagonal)
    assert trails.length[0] == length_of(optimum_of(grid))
    back = np.zeros(colony.allowed.size, dtype=np.int32)
    assert read_cells(colony, trails, 0, back) == len(cells)
    assert back[: len(cells)].tolist() == cells.tolist()


def test_the_way_that_the_refused_ones_are_made_from_is_accepted() -> None:
    assert written(numbers(GRID, WAY)) == numbers(GRID, WAY)


@pytest.mark.parametrize(
    ("fault", "path"),
    [
        ("a jump over a cell", [(0, 0), (2, 1), (2, 2), (1, 3)]),
        ("a jump to the next row", [(0, 0), (1, 0), (0, 3), (1, 3)]),
        ("standing still", [(0, 0), (1, 0), (1, 0), (2, 1), (2, 2), (1, 3)]),
        ("a move onto an obstacle", [(0, 0), (1, 1), (2, 2), (1, 3)]),
        ("a move that squeezes through", [(0, 0), (0, 1), (1, 2), (1, 3)]),
        ("a move off the map", [(0, 0), (-1, 1), (0, 1), (1, 0), (2, 1), (2, 2), (1, 3)]),
        ("another start", WAY[1:]),
        ("another end", WAY[:-1]),
        ("the goal alone", WAY[-1:]),
        ("nothing", []),
    ],
)
def test_what_is_no_path_is_refused(fault: str, path: Path) -> None:
    assert written(numbers(GRID, path)) is None, fault


@pytest.mark.parametrize("count", [-1, 0, 1])
def test_a_count_that_is_none_is_refused(count: int) -> None:
    colony = colony_on(problem_on(GRID))
    cells = np.array(numbers(GRID, WAY), dtype=np.int32)
    assert not write_cells(colony, cells, count, new_trails(1, colony.allowed.size), 0)
    assert not write_cells(colony, cells, len(cells) + 1, new_trails(1, colony.allowed.size), 0)


@pytest.mark.parametrize("cell", [-1, -(2**31), 2**31 - 1, 10_000, 29, 30, 31])
def test_cells_off_the_map_are_refused(cell: int) -> None:
    path = numbers(GRID, WAY)
    assert written([path[0], cell, *path[1:]]) is None
    assert written([path[0], cell, path[-1]]) is None


def test_a_length_is_straight_moves_and_sqrt2_for_each_diagonal_one() -> None:
    trails = new_trails(3, 10)
    measure(trails, 1, 5, 2)
    assert (trails.steps[1], trails.straight[1]) == (5, 2)
    assert trails.length[1] == 2 + 3 * math.sqrt(2)
    assert trails.length[[0, 2]].tolist() == [math.inf, math.inf]


def test_a_copied_trail_is_the_same_path_in_another_row() -> None:
    colony = colony_on(problem_on(GRID))
    source, target = trails_of(colony, None, [6, 7, 0, 1]), new_trails(2, colony.allowed.size)
    copy_trail(source, 1, target, 0)
    cells = np.zeros(colony.allowed.size, dtype=np.int32)
    assert cells[: read_cells(colony, target, 0, cells)].tolist() == numbers(GRID, WAY)
    assert target.length[0] == source.length[1]
    assert target.straight[0] == source.straight[1]
    assert target.length[1] == math.inf
