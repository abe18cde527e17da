"""The shortest any-angle path, against all segments between all corners, in whole numbers and fractions."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction
from heapq import heappop, heappush
from itertools import pairwise, permutations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import random_grid

from acoexp import Grid
from acoexp.grid import any_angle
from acoexp.grid.any_angle import any_angle_length

Point = tuple[Fraction, Fraction]
"""As (x, y), y down."""
Cells = frozenset[tuple[int, int]]
Node = tuple[Point, Cells]
"""A point, and the free cells about it between which one may pass there."""


class Plane:
    """The free ground of a map, its obstacles as closed squares that may be touched."""

    def __init__(self, grid: Grid) -> None:
        self.free = {(row, col) for row, col in np.argwhere(~grid.obstacles).tolist()}
        self.squeezes = grid.moves == "free"
        self.rows, self.cols = grid.shape

    def sides(self, point: Point) -> list[Cells]:
        """Return the free cells that a point belongs to, in groups that hang together there."""
        (x, y), groups = point, list[set[tuple[int, int]]]()
        rows = {math.floor(y), math.ceil(y) - 1}
        cols = {math.floor(x), math.ceil(x) - 1}
        for cell in {(row, col) for row in rows for col in cols} & self.free:
            near = [g for g in groups if self.squeezes or any(math.dist(cell, other) == 1 for other in g)]
            groups = [group for group in groups if group not in near] + [{cell}.union(*near)]
        return [frozenset(group) for group in groups]

    def passages(self, a: Point, b: Point) -> Iterator[tuple[Cells, Cells]]:
        """Yield from which side of a which side of b is reached straight on."""
        places = [self.at(a, b, t) for t in self.crossings(a, b)]
        halves = [((p[0] + q[0]) / 2, (p[1] + q[1]) / 2) for p, q in pairwise(places)]
        for first in self.sides(a):
            reached = [first]
            for half, place in zip(halves, places[1:], strict=True):
                reached = self.touching(self.sides(half), reached)
                reached = self.touching(self.sides(place), reached)
            for last in reached:
                yield first, last

    @staticmethod
    def touching(sides: Iterable[Cells], reached: list[Cells]) -> list[Cells]:
        return [side for side in sides if any(side & other for other in reached)]

    @staticmethod
    def at(a: Point, b: Point, t: Fraction) -> Point:
        return a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t

    @staticmethod
    def crossings(a: Point, b: Point) -> list[Fraction]:
        """Return where the way from a to b crosses a line between cells, from 0 to 1."""
        found = {Fraction(0), Fraction(1)}
        for begin, end in zip(a, b, strict=True):
            if begin != end:
                low, high = sorted((begin, end))
                found |= {(line - begin) / (end - begin) for line in range(math.ceil(low), math.floor(high) + 1)}
        return sorted(found)


def by_all_segments(grid: Grid) -> float:
    """Return the length of a shortest path, by Dijkstra's algorithm on all corners of cells."""
    plane = Plane(grid)
    start, goal = ((Fraction(2 * c + 1, 2), Fraction(2 * r + 1, 2)) for r, c in (grid.start, grid.goal))
    corners = [(Fraction(x), Fraction(y)) for x in range(plane.cols + 1) for y in range(plane.rows + 1)]
    ways: dict[Node, list[tuple[Node, float]]] = {}
    for a, b in permutations([*corners, start, goal], 2):
        for first, last in plane.passages(a, b):
            ways.setdefault((a, first), []).append(((b, last), math.dist(a, b)))
    begin, end = (start, frozenset({grid.start})), (goal, frozenset({grid.goal}))
    lengths, waiting, done = {begin: 0.0}, [(0.0, 0, begin)], set[Node]()
    while waiting:
        length, _, node = heappop(waiting)
        if node == end:
            return length
        if node in done:
            continue
        done.add(node)
        for other, more in ways.get(node, []):
            if length + more < lengths.get(other, math.inf):
                lengths[other] = length + more
                heappush(waiting, (length + more, len(waiting) + 1000 * len(done), other))
    raise AssertionError("a grid has a way from start to goal")


def found(grid: Grid) -> float:
    return any_angle_length(grid.obstacles, grid.start, grid.goal, grid.moves == "free")


@settings(max_examples=60, deadline=None)
@given(
    st.builds(
        random_grid,
        st.integers(0, 2**32),
        st.integers(2, 5),
        st.integers(2, 5),
        st.sampled_from(["free", "no_squeeze"]),
        st.floats(0.1, 0.6),
    )
)
def test_it_is_the_shortest_of_all_ways_along_segments_between_corners(grid: Grid) -> None:
    assert found(grid) == pytest.approx(by_all_segments(grid), abs=1e-9)


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
@pytest.mark.parametrize("seed", range(8))
def test_it_is_the_same_from_either_end_and_turned_over_and_no_longer_than_along_moves(
    seed: int, moves: str
) -> None:
    grid = random_grid(seed, 40, 31, moves, 0.3)
    length = found(grid)
    back = Grid(grid.obstacles, start=grid.goal, goal=grid.start, moves=moves)
    turned = Grid(grid.obstacles.T, start=grid.start[::-1], goal=grid.goal[::-1], moves=moves)
    assert math.dist(grid.start, grid.goal) - 1e-9 <= length <= grid.optimum + 1e-9
    assert found(back) == pytest.approx(length, abs=1e-9)
    assert found(turned) == pytest.approx(length, abs=1e-9)


def test_it_bends_at_the_corners_of_an_obstacle() -> None:
    grid = Grid([[0, 0, 0], [0, 1, 0], [0, 1, 0]], start=(2, 0), goal=(2, 2))
    assert found(grid) == pytest.approx(1 + 2 * math.hypot(0.5, 1.5))


def test_two_obstacles_that_meet_at_a_corner_let_a_path_through_where_they_let_a_move() -> None:
    walls = np.array([[0, 0, 1], [0, 1, 0], [0, 0, 0]], dtype=bool)
    assert any_angle_length(walls, (0, 1), (1, 2), squeezes=True) == pytest.approx(math.sqrt(2))
    assert any_angle_length(walls, (0, 1), (1, 2), squeezes=False) > 3.0


@pytest.mark.parametrize(("bound", "value"), [("MOST_STEPS", 3), ("MOST_CELLS", 899)])
def test_a_search_that_would_take_too_long_is_given_up(
    bound: str, value: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(any_angle, bound, value)
    grid = random_grid(1, 30, 30, "no_cut")
    assert math.isnan(found(grid))
