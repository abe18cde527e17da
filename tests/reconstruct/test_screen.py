"""The exact filter against scipy's Dijkstra and against walks counted in plain Python."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.typing import NDArray
from reference import Pair, moves_of
from samples import reach_of

from acoexp import Grid, MapError
from acoexp.reconstruct.published import RULES
from acoexp.reconstruct.screen import SIZE, Screen


def random_obstacles(seed: int) -> NDArray[np.bool_]:
    """Return obstacles as thick as they come, start and goal free."""
    rng = np.random.default_rng(seed)
    obstacles = rng.random((SIZE, SIZE)) < rng.uniform(0.0, 0.3)
    obstacles[0, 0] = obstacles[-1, -1] = False
    return obstacles


def grid_of(obstacles: NDArray[np.bool_], moves: str) -> Grid | None:
    """Return the map, or None if it is cut in two or has pockets."""
    allowed = moves_of(SimpleNamespace(obstacles=obstacles.tolist(), moves=moves))
    if len(reach_of(allowed, (0, 0))) < (~obstacles).sum():
        return None
    return Grid(obstacles, moves=moves)


@pytest.mark.parametrize("moves", RULES)
def test_the_optimum_is_that_of_dijkstra(moves: str) -> None:
    screen, whole = Screen(moves), 0
    for seed in range(60):
        obstacles = random_obstacles(seed)
        grid = grid_of(obstacles, moves)
        whole += grid is not None
        assert screen.optimum(obstacles) == (grid and grid.optimum_pair)
    assert 10 < whole < 60


def test_a_map_without_a_way_has_no_optimum() -> None:
    obstacles = np.zeros((SIZE, SIZE), dtype=bool)
    obstacles[9] = True
    with pytest.raises(MapError):
        Grid(obstacles)
    assert Screen("free").optimum(obstacles) is None


def test_a_map_with_a_pocket_has_no_optimum() -> None:
    obstacles = np.zeros((SIZE, SIZE), dtype=bool)
    obstacles[4:7, 4:7] = True
    assert Screen("free").optimum(obstacles) is not None
    obstacles[5, 5] = False
    assert Screen("free").optimum(obstacles) is None


@pytest.mark.parametrize("moves", RULES)
def test_a_length_is_there_if_some_walk_has_it(moves: str) -> None:
    screen, obstacles = Screen(moves), random_obstacles(3)
    expected = walks(obstacles, moves, most=24)
    found = {(n - d, d) for n in range(19, 25) for d in range(n + 1) if screen.leads(obstacles, (n - d, d))}
    assert found == expected
    assert expected


def walks(obstacles: NDArray[np.bool_], moves: str, most: int) -> set[Pair]:
    """Return the pairs (straight, diagonal) of all walks from corner to corner of so many moves at most."""
    allowed = moves_of(SimpleNamespace(obstacles=obstacles.tolist(), moves=moves))
    here, arrived = {((0, 0), 0)}, set()
    for n in range(1, most + 1):
        here = {(target, d + way % 2) for cell, d in here for way, target in allowed[cell].items()}
        arrived |= {(n - d, d) for cell, d in here if cell == (SIZE - 1, SIZE - 1)}
    return arrived
