"""``map=maze``: one way between any two places, corridors of one width, loops if they are asked for."""

from __future__ import annotations

import numpy as np
import pytest
from reference import moves_of
from samples import reach_of

from acoexp import SettingsError, load_map


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("moves", ["no_squeeze", "four"])
def test_a_maze_is_a_tree_of_all_its_cells(moves: str, seed: int) -> None:
    """Its free cells hang together by one straight move less than there are cells."""
    grid = load_map("maze", size=(21, 31), seed=seed, moves=moves)
    allowed = moves_of(grid)
    straight = sum(direction % 2 == 0 for ways in allowed.values() for direction in ways) // 2
    assert reach_of(allowed, grid.start) == allowed.keys()
    assert straight == len(allowed) - 1
    assert len(allowed) == 2 * 11 * 16 - 1


@pytest.mark.parametrize("width", [2, 3, 5])
def test_a_wide_maze_is_a_narrow_one_widened(width: int) -> None:
    rows, cols = 5, 7
    narrow = load_map("maze", size=(2 * rows - 1, 2 * cols - 1), seed=4).obstacles
    size = (rows * (width + 1) - 1, cols * (width + 1) - 1)
    wide = load_map("maze", size=size, seed=4, width=width).obstacles
    at_rows, at_cols = (
        np.concatenate([[n * (width + 1), n * (width + 1) + width] for n in range(count)])[:-1]
        for count in (rows, cols)
    )
    assert np.array_equal(wide[np.ix_(at_rows, at_cols)], narrow)


def test_the_last_corridor_takes_what_is_left_over() -> None:
    obstacles = load_map("maze", size=(20, 20), seed=1).obstacles
    assert np.array_equal(obstacles[-1], obstacles[-2])
    assert np.array_equal(obstacles[:, -1], obstacles[:, -2])


def test_loops_take_walls_away() -> None:
    free = [(~load_map("maze", size=(41, 41), loops=loops).obstacles).sum() for loops in (0.0, 0.2, 1.0)]
    assert free[0] == 2 * 21 * 21 - 1
    assert free[1] == pytest.approx(free[0] + 0.2 * (2 * 20 * 21 - 440), rel=0.03)
    assert free[2] == 41 * 41 - 20 * 20


def test_one_corridor_may_be_all_there_is() -> None:
    assert not load_map("maze", size=(3, 3), width=5).obstacles.any()
    assert load_map("maze", size=(1, 9)).optimum_pair == (8, 0)


@pytest.mark.parametrize("parameters", [{"width": 0}, {"width": 2049}, {"loops": 1.5}, {"loops": -0.1}])
def test_what_makes_no_maze_is_refused(parameters: dict[str, float]) -> None:
    with pytest.raises(SettingsError, match=r"^map\.(width|loops): expected a (whole )?number from "):
        load_map("maze", **parameters)


def test_its_name_has_width_and_loops() -> None:
    assert load_map("maze").name == "maze-50x50-w1-s0"
    assert load_map("maze", loops=0.1, width=3, seed=2).name == "maze-50x50-w3-l0.1-s2"
