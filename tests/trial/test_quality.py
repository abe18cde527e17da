"""The quality of a path, by its definitions, on paths that ants found."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from reference import Path
from samples import walks

from acoexp import Grid, solve
from acoexp.grid.frame import Frame
from acoexp.grid.moves import DIRECTIONS
from acoexp.trial.quality import Quality, in_metres, quality_of


def moves_along(path: Path) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
    """Return the directions of a path."""
    steps = [DIRECTIONS.index((b[0] - a[0], b[1] - a[1])) for a, b in pairwise(path)]
    return np.array(steps, dtype=np.uint8)


def angle_between(a: tuple[int, int], b: tuple[int, int]) -> float:
    """Return the angle between two steps, from 0 to pi."""
    return math.acos(max(-1.0, min(1.0, (a[0] * b[0] + a[1] * b[1]) / math.hypot(*a) / math.hypot(*b))))


@settings(deadline=None, max_examples=50)
@given(walks())
def test_it_is_what_a_person_would_measure(way: tuple[Grid, Path]) -> None:
    grid, path = way
    found = quality_of(moves_along(path), grid.clearance[tuple(np.array(path).T)], grid.any_angle_optimum)
    angles = [angle_between(*pair) for pair in pairwise([(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(path)])]
    assert found.turns == sum(angle > 0.1 for angle in angles)
    assert found.turning == pytest.approx(sum(angles), abs=1e-6)
    walls = np.argwhere(grid.obstacles).tolist()
    if walls:
        clearances = [min(math.dist(cell, wall) for wall in walls) for cell in path]
        assert found.clearance_mean == pytest.approx(sum(clearances) / len(path))
        assert found.clearance_least == pytest.approx(min(clearances))
    else:
        assert math.isnan(found.clearance_mean)
        assert math.isnan(found.clearance_least)
    length = sum(math.dist(*pair) for pair in pairwise(path))
    assert found.detour == pytest.approx(length / grid.any_angle_optimum)
    assert found.detour > 1.0 - 1e-9


def test_where_there_is_no_path_there_is_none() -> None:
    result = solve(Grid([[0, 0, 1], [1, 0, 0]]), "aco", 0, iterations=1, max_steps=1)
    assert result.moves is None
    assert all(map(math.isnan, result.quality))


def test_in_metres_are_the_clearances_of_a_map_with_a_frame() -> None:
    values = Quality(3.0, 2.0, 1.5, 1.0, 1.1)._asdict()
    assert in_metres(values, None) == {}
    assert in_metres(values, Frame(rows=3, resolution=0.5)) == {"clearance_mean_m": 0.75, "clearance_least_m": 0.5}


def test_a_result_that_nobody_asks_for_it_computes_nothing() -> None:
    grid = Grid(np.eye(5)[::-1] * [0, 1, 1, 1, 0])
    result = solve(grid, "aco", 0, iterations=2)
    assert not {"clearance", "any_angle_optimum"} & vars(grid).keys()
    assert result.moves is not None
    assert result.path is not None
    along = Grid(grid.obstacles).clearance[tuple(result.path.T)]
    assert result.quality == quality_of(result.moves, along, Grid(grid.obstacles).any_angle_optimum)
    assert {"clearance", "any_angle_optimum"} <= vars(grid).keys()
