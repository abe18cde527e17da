"""Shortcuts, against a plain search of its own, and on whatever an ant may bring."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import reference
from hypothesis import given, settings
from reference import Cell, Moves, Path, length_of, moves_of, pair_of
from samples import colony_on, is_way, number_of, problem_on, random_grid, walks

from acoexp import Grid
from acoexp.strategies.post.shortcut import Shortcut, optimise


def applied(grid: Grid, path: Path, **parameters: Any) -> Path:
    """Return what the post-optimiser makes of a path."""
    problem = problem_on(grid)
    colony, own = colony_on(problem), Shortcut(**parameters).prepare(problem)
    cells = np.zeros(colony.allowed.size, dtype=np.int32)
    cells[: len(path)] = [number_of(problem, cell) for cell in path]
    count = optimise(colony, own, cells, len(path))
    assert (own.place == -1).all()  # else it would not be clean for the next ant
    rows, cols = np.divmod(cells[:count], problem.width)
    return [(int(row) - 1, int(col) - 1) for row, col in zip(rows, cols, strict=True)]


def run_between(moves: Moves, a: Cell, b: Cell, rule: str) -> Path | None:
    """Return the cells of a run, but for ``a``, diagonal or column first if both are free; None if none is."""
    down, right = b[0] - a[0], b[1] - a[1]
    bends, steps = min(abs(down), abs(right)), max(abs(down), abs(right))
    aslant = [(np.sign(down), np.sign(right))] * bends
    along = [(np.sign(down), 0) if abs(down) > abs(right) else (0, np.sign(right))] * (steps - bends)
    if rule == "four":
        aslant, along = [(np.sign(down), 0)] * abs(down), [(0, np.sign(right))] * abs(right)
        steps = abs(down) + abs(right)
    for legs in (aslant + along, along + aslant):
        cell, run = a, []
        for step in legs:
            target = (cell[0] + int(step[0]), cell[1] + int(step[1]))
            if target not in moves[cell].values():
                break
            run.append(cell := target)
        if len(run) == steps:
            return run
    return None


def straightened(path: Path, moves: Moves, rule: str) -> Path:
    """Lead a path straight on until it gets no shorter; the farthest cell is found by doubling and halving."""
    kept, place = [path[0]], 0
    while place < len(path) - 1:
        place, stride, grows = place + 1, 1, True
        while stride:
            ahead = place + stride
            if ahead < len(path) and run_between(moves, kept[-1], path[ahead], rule) is not None:
                place = ahead
            else:
                grows = False
            stride = stride * 2 if grows else stride // 2
        kept += run_between(moves, kept[-1], path[place], rule) or []
    kept = without_loops(kept)
    shorter = length_of(pair_of(kept)) < length_of(pair_of(path)) - 1e-9
    return straightened(kept, moves, rule) if shorter else kept


def without_loops(path: Path) -> Path:
    """Go on from each cell where the path leaves it for the last time."""
    last, kept, place = {cell: place for place, cell in enumerate(path)}, [], 0
    while place < len(path):
        kept.append(path[place])
        place = last[path[place]] + 1
    return kept


def test_a_cell_that_runs_lead_over_twice_is_on_the_path_once() -> None:
    grid = random_grid(561, 7, 5, "free", 0.4375)
    around = [(5, 2), (6, 1), (5, 0), (4, 0), (4, 1), (3, 2), (2, 3), (2, 4)]
    assert is_way(grid, around)
    assert is_way(grid, applied(grid, around))


def test_a_path_of_as_many_but_straighter_moves_is_shorter_so_it_is_gone_over_again() -> None:
    grid = random_grid(1814, 4, 5, "no_cut", 0.25)
    zigzag = [(0, 3), (1, 4), (2, 3), (3, 2), (2, 1), (3, 0)]
    assert is_way(grid, zigzag)
    assert applied(grid, zigzag) == [(0, 3), (1, 3), (2, 2), (3, 1), (3, 0)]


@settings(max_examples=200, deadline=None)
@given(walks())
def test_every_path_becomes_what_the_plain_search_makes_of_it(walk: tuple[Grid, Path]) -> None:
    grid, path = walk
    moves = moves_of(grid)
    assert applied(grid, path) == straightened(path, moves, grid.moves)
    optimised = reference.optimised(path, moves)
    assert applied(grid, path, geometric=True) == straightened(optimised, moves, grid.moves)


@settings(max_examples=200, deadline=None)
@given(walks())
def test_it_is_a_way_and_never_longer(walk: tuple[Grid, Path]) -> None:
    grid, path = walk
    for geometric in (False, True):
        shorter = applied(grid, path, geometric=geometric)
        assert is_way(grid, shorter)
        assert length_of(pair_of(shorter)) <= length_of(pair_of(path)) + 1e-9


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_where_nothing_is_in_the_way_it_finds_the_shortest(moves: str) -> None:
    grid = Grid(np.zeros((9, 14)), start=(8, 0), goal=(0, 13), moves=moves)
    across = [(row, col) for col in range(14) for row in (range(8, -1, -1) if col % 2 == 0 else range(9))]
    around = across[: across.index(grid.goal) + 1]
    assert is_way(grid, around)
    assert length_of(pair_of(applied(grid, around))) == grid.optimum
