"""The geometric post-optimiser, rule by rule, on paths drawn as letters in the order of the alphabet."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import reference
import reference_paths
from hypothesis import given, settings
from hypothesis import strategies as st
from reference import Path, length_of, moves_of, pair_of
from samples import colony_on, drawn, is_way, number_of, problem_on, walks

from acoexp import Grid
from acoexp.strategies.post.geometric import (
    Geometric,
    cut_circles,
    cut_saw_teeth,
    optimise,
    remove_crossings,
)

Rule = Callable[..., Any]


def applied(rule: Rule, grid: Grid, path: Path) -> Path:
    """Return what a rule makes of a path."""
    problem = problem_on(grid)
    colony, own = colony_on(problem), Geometric().prepare(problem)
    cells = np.zeros(colony.allowed.size, dtype=np.int32)
    cells[: len(path)] = [number_of(problem, cell) for cell in path]
    count = rule(colony, own, cells, len(path))
    assert (own.place == -1).all()  # else it would not be clean for the next ant
    rows, cols = np.divmod(cells[:count], problem.width)
    return [(int(row) - 1, int(col) - 1) for row, col in zip(rows, cols, strict=True)]


def left_of(rule: Rule, drawing: str, moves: str = "no_squeeze") -> str:
    """Return the letters of the cells that a rule leaves of the path drawn."""
    grid, named = drawn(drawing, moves)
    letters = {cell: letter for letter, cell in named.items()}
    path = [named[letter] for letter in sorted(named)]
    assert is_way(grid, path)
    shorter = applied(rule, grid, path)
    assert is_way(grid, shorter)
    return "".join(letters[cell] for cell in shorter)


def test_where_two_moves_cross_what_lies_between_them_goes() -> None:
    loop = """
        .aef
        .db.
        .c..
    """
    assert left_of(remove_crossings, loop) == "aef"


def test_one_crossing_after_another_goes() -> None:
    two_loops = """
        .aefjk
        .dbig.
        .c.h..
    """
    assert left_of(remove_crossings, two_loops) == "aefjk"


def test_crossings_inside_a_loop_go_with_it() -> None:
    loops_in_loops = """
        .akl.
        .jbh.
        ..icg
        ...fd
        ...e.
    """
    assert left_of(remove_crossings, loops_in_loops) == "akl"


@pytest.mark.parametrize("drawing", ["ace .bd", "a.c.e .b.d.", "abcd ..fe", "a.. .b. ..c"])
def test_moves_that_do_not_cross_stay(drawing: str) -> None:
    assert left_of(remove_crossings, drawing) == "".join(sorted(set(drawing) - set(". ")))


@pytest.mark.parametrize("turn", [3, 5])
@pytest.mark.parametrize("direction", range(8))
def test_where_the_angle_is_45_degrees_the_corner_goes(direction: int, turn: int) -> None:
    a = (2, 2)
    b = tuple(np.add(a, reference_paths.STEPS[direction]).tolist())
    c = tuple(np.add(b, reference_paths.STEPS[(direction + turn) % 8]).tolist())
    grid = Grid(np.zeros((5, 5)), start=a, goal=c)
    assert applied(cut_saw_teeth, grid, [a, b, c]) == [a, c]


@pytest.mark.parametrize("turn", [0, 1, 2, 6, 7])
@pytest.mark.parametrize("direction", range(8))
def test_where_the_angle_is_wider_the_corner_stays(direction: int, turn: int) -> None:
    a = (2, 2)
    b = tuple(np.add(a, reference_paths.STEPS[direction]).tolist())
    c = tuple(np.add(b, reference_paths.STEPS[(direction + turn) % 8]).tolist())
    grid = Grid(np.zeros((5, 5)), start=a, goal=c)
    assert applied(cut_saw_teeth, grid, [a, b, c]) == [a, b, c]


def test_a_saw_loses_all_its_teeth() -> None:
    saw = """
        .b.e.h
        acdfgi
    """
    assert left_of(cut_saw_teeth, saw) == "acdfgi"


def test_a_tooth_that_shows_only_when_another_is_gone_goes_too() -> None:
    tooth_behind_tooth = """
        adc
        .b.
    """
    assert left_of(cut_saw_teeth, tooth_behind_tooth) == "ad"


def test_from_each_cell_the_way_goes_on_to_the_neighbour_that_comes_last() -> None:
    """The path of Fig. 6: cells 13, 10, 6, 2, 3, 4, 8, 12, 15, 16 become 13, 10, 15, 16."""
    figure_6 = """
        .def
        #c#g
        .b#h
        a.ij
    """
    assert left_of(cut_circles, figure_6) == "abij"


@pytest.mark.parametrize(("moves", "left"), [("free", "ace"), ("no_squeeze", "ace"), ("no_cut", "abcde")])
def test_a_corner_is_cut_only_as_far_as_the_maps_rule_allows(moves: str, left: str) -> None:
    corner = """
        bcd
        a#e
    """
    assert left_of(cut_circles, corner, moves) == left


def test_the_three_rules_together_leave_nothing_to_cut() -> None:
    everything = """
        .aefhij
        .db.gnk
        .c..oml
    """
    assert left_of(optimise, everything) == "aefhikmo"


@settings(deadline=None, max_examples=300)
@given(walks())
def test_each_rule_does_to_any_way_what_the_reference_does(walk: tuple[Grid, Path]) -> None:
    grid, path = walk
    moves = moves_of(grid)
    assert applied(remove_crossings, grid, path) == reference_paths.without_crossings(path)
    assert applied(cut_saw_teeth, grid, path) == reference_paths.without_saw_teeth(path)
    assert applied(cut_circles, grid, path) == reference_paths.without_detours(path, moves)
    assert applied(optimise, grid, path) == reference.optimised(path, moves)


@settings(deadline=None, max_examples=200)
@given(walks(), st.sampled_from([remove_crossings, cut_saw_teeth, cut_circles, optimise]))
def test_each_rule_leaves_a_way_that_is_not_longer_and_that_it_leaves_alone(
    walk: tuple[Grid, Path], rule: Rule
) -> None:
    grid, path = walk
    shorter = applied(rule, grid, path)
    assert is_way(grid, shorter)
    assert length_of(pair_of(shorter)) <= length_of(pair_of(path))
    assert applied(rule, grid, shorter) == shorter
