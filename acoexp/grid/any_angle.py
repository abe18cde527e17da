"""The length of the shortest any-angle path: straight on from point to point, not from cell to neighbouring cell.

Free ground is cut into its rows' runs of free cells, which are rectangles, and the search goes over intervals of
the lines between them, each seen from one point, its *root*: Polyanya (Cui, Harabor and Grastien 2017,
"Compromise-free pathfinding on a navigation mesh"), which on these rectangles is Anya (Harabor et al. 2016,
"Optimal any-angle pathfinding in practice"). It is exact: roots are corners of obstacles, whose coordinates are
whole numbers, so what is nearer to one than ``_SAME`` lies on it.

Paths may touch obstacles. Two that meet at a corner alone let one through under the rule ``free``, as they do a
move; under the other rules they are closed. The ground outside of the map is none.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from heapq import heappop, heappush
from math import hypot, inf, nan
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

MOST_STEPS = 100_000
"""Intervals after which a search is given up: some seconds."""

MOST_CELLS = 512 * 512
"""Cells of the largest map that is searched; what is looked at before the first step grows with them."""

_SAME = 1e-7

Run = tuple[int, int]
"""The lines, left and right, between which cells of a row are free."""


class _Interval(NamedTuple):
    """A part of the lower or upper side of a run, through which a path enters it.

    Attributes:
        estimate: Length of the shortest path through it by the root, were there no further obstacle.
        length: That up to the root.
        root: The last corner (x, y), which sees all of the interval; x to the right and y down, in cells.
        row, run: The run that is entered.
        down: 1 if it is entered downwards, -1 if upwards.
        left, right: The interval's ends.
    """

    estimate: float
    length: float
    root: tuple[float, float]
    row: int
    run: Run
    down: int
    left: float
    right: float


def any_angle_length(
    obstacles: NDArray[np.bool_], start: tuple[int, int], goal: tuple[int, int], squeezes: bool
) -> float:
    """Return the length of a shortest any-angle path between the centres of two cells, in cells.

    Args:
        obstacles: bool[rows, cols], True where no path leads.
        start: Its first cell, (row, column), free.
        goal: Its last one, which a way leads to.
        squeezes: Whether it may pass between two obstacles that meet at a corner.

    Returns:
        The length; nan where ``MOST_STEPS`` do not suffice, and on maps of more than ``MOST_CELLS``.
    """
    if obstacles.size > MOST_CELLS:
        return nan
    return _Search(obstacles, goal, squeezes).run(start)


class _Search:
    def __init__(self, obstacles: NDArray[np.bool_], goal: tuple[int, int], squeezes: bool) -> None:
        self._runs = [_runs_of(row) for row in obstacles]
        self._squeezes = squeezes
        self._goal_row, self._goal = goal[0], (goal[1] + 0.5, goal[0] + 0.5)
        self._waiting: list[_Interval] = []
        self._nearest: dict[tuple[float, float], float] = {}
        self._seen: dict[tuple[float, float], set[tuple[float, ...]]] = {}

    def run(self, start: tuple[int, int]) -> float:
        row, root = start[0], (start[1] + 0.5, start[0] + 0.5)
        run = self._run_with(*start)
        self._close_dead_ends({(row, run), (self._goal_row, self._run_with(self._goal_row, self._goal[0]))})
        if row == self._goal_row and run[0] < self._goal[0] < run[1]:
            return abs(self._goal[0] - root[0])
        for down in (1, -1):
            self._see(0.0, root, row, run, down, *run)
        for _ in range(MOST_STEPS):
            if not self._waiting:
                return inf
            interval = heappop(self._waiting)
            if interval.row == self._goal_row and interval.run[0] < self._goal[0] < interval.run[1]:
                return interval.estimate
            if interval.length <= self._nearest[interval.root] + _SAME:
                self._enter(interval)
        return nan

    def _run_with(self, row: int, x: float) -> Run:
        return next(run for run in self._runs[row] if run[0] <= x < run[1])

    def _close_dead_ends(self, kept: set[tuple[int, Run]]) -> None:
        """Leave out runs with one opening, again and again, but for some: no way leads in and out."""
        beyond = {
            (row, run): {
                (row + down, other) for down in (1, -1) for other, _, _ in self._openings(row, run, down, *run)
            }
            for row, runs in enumerate(self._runs)
            for run in runs
        }
        ends = [place for place, others in beyond.items() if len(others) <= 1 and place not in kept]
        while ends:
            place = ends.pop()
            for other in beyond.pop(place):
                beyond[other].remove(place)
                if len(beyond[other]) == 1 and other not in kept:
                    ends.append(other)
        self._runs = [[run for run in runs if (row, run) in beyond] for row, runs in enumerate(self._runs)]

    def _enter(self, interval: _Interval) -> None:
        """Look on from an interval: at what its root sees beyond it, and at what the corners at its ends do."""
        _, length, (x, y), row, run, down, left, right = interval
        near = row if down > 0 else row + 1
        if y == near:  # along the side of the run, to where the interval begins
            end = min(max(x, left), right)
            length += abs(end - x)
            self._see(length, (end, near), row, run, down, *run)
            self._look_back(length, (end, near), interval, *run)
            return
        scale = (near + down - y) / (near - y)
        seen_left, seen_right = (_snapped(x + (end - x) * scale) for end in (left, right))
        self._see(length, (x, y), row, run, down, max(seen_left, run[0]), min(seen_right, run[1]))
        if self._is_corner(left, left - 1, interval):
            around = length + hypot(left - x, near - y)
            self._see(around, (left, near), row, run, down, run[0], min(seen_left, run[1]))
            self._look_back(around, (left, near), interval, run[0], left)
        if self._is_corner(right, right, interval):
            around = length + hypot(right - x, near - y)
            self._see(around, (right, near), row, run, down, max(seen_right, run[0]), run[1])
            self._look_back(around, (right, near), interval, right, run[1])

    def _is_corner(self, end: float, beside: float, interval: _Interval) -> bool:
        """Tell whether an end of an interval lies on an obstacle in the column beside it, to turn round."""
        if end in interval.run:
            return True
        return end == int(end) and not any(
            left <= beside < right for left, right in self._near(interval.row - interval.down, beside, beside + 1)
        )

    def _look_back(
        self, length: float, root: tuple[float, float], interval: _Interval, low: float, high: float
    ) -> None:
        """See other openings on the side of a run by which it was entered: back out of it, around a corner."""
        _, _, _, row, run, down, left, right = interval
        for opening in self._openings(row, run, -down, low, high):
            if not opening[1] <= left <= right <= opening[2]:
                self._put(length, root, row - down, -down, *opening)

    def _see(
        self, length: float, root: tuple[float, float], row: int, run: Run, down: int, low: float, high: float
    ) -> None:
        """See the openings on a run's far side, between two of its points."""
        if low <= high:
            for opening in self._openings(row, run, down, low, high):
                self._put(length, root, row + down, down, *opening)

    def _openings(
        self, row: int, run: Run, down: int, low: float, high: float
    ) -> Iterator[tuple[Run, float, float]]:
        """Yield the runs beyond a side of a run, each with the ends of what both share between two points."""
        for other in self._near(row + down, low, high):
            left, right = max(run[0], other[0]), min(run[1], other[1])
            if left < right or (left == right and self._squeezes):
                left_seen, right_seen = max(left, low), min(right, high)
                if left_seen <= right_seen:
                    yield other, left_seen, right_seen

    def _near(self, row: int, low: float, high: float) -> Iterator[Run]:
        """Yield the runs of a row that reach into or touch what is between two points."""
        runs = self._runs[row] if 0 <= row < len(self._runs) else []
        for place in range(bisect_left(runs, low, key=lambda run: run[1]), len(runs)):
            if runs[place][0] > high:
                return
            yield runs[place]

    def _put(
        self,
        length: float,
        root: tuple[float, float],
        row: int,
        down: int,
        run: Run,
        left: float,
        right: float,
    ) -> None:
        """Let an interval wait its turn, unless its root is reached by a shorter way, or it has been seen."""
        if length > self._nearest.get(root, inf) + _SAME:
            return
        if length < self._nearest.get(root, inf) - _SAME:
            self._nearest[root], self._seen[root] = length, set()
        if (key := (row, down, left, right)) in self._seen[root]:
            return
        self._seen[root].add(key)
        near = row if down > 0 else row + 1
        goal_x, goal_y = self._goal
        if (goal_y - near) * down < 0:  # to a goal behind the line as far as to its image before it
            goal_y = 2 * near - goal_y
        crossing = root[0] + (goal_x - root[0]) * (near - root[1]) / (goal_y - root[1])
        through = min(max(crossing, left), right)
        rest = hypot(through - root[0], near - root[1]) + hypot(goal_x - through, goal_y - near)
        heappush(self._waiting, _Interval(length + rest, length, root, row, run, down, left, right))


def _runs_of(row: NDArray[np.bool_]) -> list[Run]:
    """Return the runs of free cells in a row, from left to right."""
    edges = np.flatnonzero(np.diff(row, prepend=True, append=True)).tolist()
    return list(zip(edges[::2], edges[1::2], strict=True))


def _snapped(x: float) -> float:
    """Return a coordinate, and that of a line where rounding alone parts it from one."""
    line = round(x)
    return float(line) if abs(x - line) < _SAME else x
