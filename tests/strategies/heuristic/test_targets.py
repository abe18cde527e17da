"""What heuristics share: a number of each cell, as seen by the moves that lead into it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from acoexp import Grid
from acoexp.grid import DIRECTIONS
from acoexp.strategies.heuristic import targets
from acoexp.strategies.heuristic.targets import at_targets, goal_distance


def test_the_distance_to_the_goal_is_the_straight_line_on_the_map_and_around_it() -> None:
    distance = goal_distance(Grid(np.zeros((3, 5)), goal=(2, 1)))
    assert distance.shape == (5, 7)
    for row in range(-1, 4):
        for col in range(-1, 6):
            assert distance[row + 1, col + 1] == pytest.approx(math.dist((row, col), (2, 1)))


@pytest.mark.parametrize("strip", [1, 12, 2**12])
def test_each_move_has_what_its_target_has(strip: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """However many rows are filled in at a time."""
    monkeypatch.setattr(targets, "_STRIP", strip)
    values = np.random.default_rng(0).uniform(size=(9, 7))
    found = at_targets(values)
    assert found.shape == (7, 5, 8)
    for (row, col, direction), value in np.ndenumerate(found):
        down, right = DIRECTIONS[direction]
        assert value == values[1 + row + down, 1 + col + right]
