"""Moves: eight directions, four rules for diagonals, exact lengths."""

from __future__ import annotations

from decimal import Decimal, localcontext
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from numpy.typing import NDArray
from reference import moves_of

from acoexp.grid import DIRECTIONS, MOVE_RULES, allowed_moves, path_length

E, NE, N, NW, W, SW, S, SE = range(8)

RULES = st.sampled_from(MOVE_RULES)
MAPS = arrays(bool, array_shapes(min_dims=2, max_dims=2, max_side=8))


def walls(*rows: str) -> NDArray[np.bool_]:
    """Return the map that rows of '.' and '#' show."""
    return np.array([[symbol == "#" for symbol in row] for row in rows])


def moves_at(obstacles: NDArray[np.bool_], row: int, col: int, rule: str) -> set[int]:
    """Return the directions in which a cell may be left."""
    bits = int(allowed_moves(obstacles, rule)[row, col])
    return {direction for direction in range(8) if bits >> direction & 1}


def test_directions_run_counter_clockwise_from_east() -> None:
    on_screen = {"E": (0, 1), "NE": (-1, 1), "N": (-1, 0), "NW": (-1, -1),
                 "W": (0, -1), "SW": (1, -1), "S": (1, 0), "SE": (1, 1)}  # fmt: skip
    assert tuple(on_screen.values()) == DIRECTIONS


def test_odd_directions_are_the_diagonals() -> None:
    assert [down != 0 and right != 0 for down, right in DIRECTIONS] == [False, True] * 4


def test_opposite_directions_lie_four_apart() -> None:
    for direction, (down, right) in enumerate(DIRECTIONS):
        assert DIRECTIONS[(direction + 4) % 8] == (-down, -right)


def test_there_are_exactly_four_rules() -> None:
    assert MOVE_RULES == ("free", "no_squeeze", "no_cut", "four")


@pytest.mark.parametrize("rule", MOVE_RULES)
def test_in_the_open_all_eight_moves_are_allowed_or_all_four(rule: str) -> None:
    assert moves_at(walls("...", "...", "..."), 1, 1, rule) == set(range(0, 8, 2 if rule == "four" else 1))


@pytest.mark.parametrize("rule", MOVE_RULES)
def test_no_move_leads_off_the_map(rule: str) -> None:
    assert moves_at(walls("..", ".."), 0, 0, rule) == {E, S} | ({SE} if rule != "four" else set())
    assert moves_at(walls("."), 0, 0, rule) == set()


@pytest.mark.parametrize("rule", MOVE_RULES)
def test_no_move_leads_onto_an_obstacle_or_away_from_one(rule: str) -> None:
    assert moves_at(walls("...", "..#", "..."), 1, 1, rule).isdisjoint({E})
    assert moves_at(walls("#.", ".."), 1, 1, rule).isdisjoint({NW})
    assert moves_at(walls("...", ".#.", "..."), 1, 1, rule) == set()


@pytest.mark.parametrize(("rule", "allowed"), [("free", True), ("no_squeeze", False), ("no_cut", False)])
def test_a_diagonal_between_two_obstacles_is_a_squeeze(rule: str, allowed: bool) -> None:
    assert (SE in moves_at(walls(".#", "#."), 0, 0, rule)) is allowed
    assert (SW in moves_at(walls("#.", ".#"), 0, 1, rule)) is allowed


@pytest.mark.parametrize(("rule", "allowed"), [("free", True), ("no_squeeze", True), ("no_cut", False)])
def test_a_diagonal_past_one_obstacle_is_a_cut(rule: str, allowed: bool) -> None:
    assert (SE in moves_at(walls(".#", ".."), 0, 0, rule)) is allowed
    assert (NW in moves_at(walls("..", "#."), 1, 1, rule)) is allowed


@settings(deadline=None)
@given(MAPS, RULES)
def test_the_table_is_that_of_plain_loops(obstacles: NDArray[np.bool_], rule: str) -> None:
    expected = moves_of(SimpleNamespace(obstacles=obstacles, moves=rule))
    for row, col in np.ndindex(obstacles.shape):
        assert moves_at(obstacles, row, col, rule) == set(expected.get((row, col), {}))


@settings(deadline=None)
@given(MAPS, RULES)
def test_every_move_can_be_taken_back(obstacles: NDArray[np.bool_], rule: str) -> None:
    for row, col in np.ndindex(obstacles.shape):
        for direction in moves_at(obstacles, row, col, rule):
            down, right = DIRECTIONS[direction]
            assert (direction + 4) % 8 in moves_at(obstacles, row + down, col + right, rule)


@settings(deadline=None)
@given(MAPS)
def test_each_rule_allows_what_the_next_stricter_one_does(obstacles: NDArray[np.bool_]) -> None:
    free, no_squeeze, no_cut, four = (allowed_moves(obstacles, rule) for rule in MOVE_RULES)
    assert not (four & ~no_cut).any()
    assert not (no_cut & ~no_squeeze).any()
    assert not (no_squeeze & ~free).any()


def test_a_path_is_as_long_as_its_moves() -> None:
    assert path_length(3, 0) == 3.0
    assert path_length(0, 1) == 2**0.5
    assert path_length(12, 13) == pytest.approx(30.3848, abs=5e-5)
    assert path_length(0, 0) == 0.0


def test_scalars_and_arrays_have_the_same_length_to_the_bit() -> None:
    """Curves are made from arrays, optima from numbers: the two must compare equal."""
    straight, diagonal = np.indices((60, 60), dtype=np.float64)
    lengths: Any = path_length(straight, diagonal)  # type: ignore[arg-type]
    assert all(lengths[s, d] == path_length(s, d) for s, d in np.ndindex(60, 60))


COUNTS = st.integers(0, 10**6)


@given(COUNTS, COUNTS, COUNTS, COUNTS)
def test_lengths_compare_as_the_numbers_they_stand_for(s1: int, d1: int, s2: int, d2: int) -> None:
    with localcontext(prec=60):
        exact = [s + d * Decimal(2).sqrt() for s, d in ((s1, d1), (s2, d2))]
    assert (path_length(s1, d1) < path_length(s2, d2)) == (exact[0] < exact[1])


@pytest.mark.parametrize(("straight", "diagonal"), [(3, 2), (7, 5), (99, 70), (3363, 2378), (1607521, 1136689)])
def test_even_the_closest_pairs_have_different_lengths(straight: int, diagonal: int) -> None:
    """The convergents of sqrt 2: no other fractions come as close to it."""
    assert path_length(straight, 0) != path_length(0, diagonal)
    assert path_length(2 * straight, diagonal) != path_length(straight, 2 * diagonal)
