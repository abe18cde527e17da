"""``map=random``: as many obstacles as the density says, anywhere."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp import SettingsError, load_map


@pytest.mark.parametrize("density", [0.1, 0.2, 0.3])
def test_the_share_of_obstacles_is_the_density(density: float) -> None:
    """Four deviations off at most, of 40 000 cells of which each is one or not."""
    obstacles = load_map("random", density=density, size=(200, 200), seed=3).obstacles
    assert abs(obstacles.mean() - density) < 4 * (density * (1 - density) / obstacles.size) ** 0.5


def test_obstacles_are_anywhere() -> None:
    """Every row and every column has about its share, and neighbours know nothing of each other."""
    obstacles = load_map("random", density=0.2, size=(300, 300), seed=1).obstacles
    for axis in (0, 1):
        assert 0.05 < obstacles.mean(axis=axis).min() < obstacles.mean(axis=axis).max() < 0.35
    pairs = obstacles[:, 1:] & obstacles[:, :-1]
    assert abs(pairs.mean() - 0.04) < 0.005


def test_without_obstacles_the_map_is_open_whatever_the_seed() -> None:
    assert not any(load_map("random", density=0.0, seed=seed).obstacles.any() for seed in range(3))


def test_only_both_ends_are_kept_free() -> None:
    grid = load_map("random", density=1.0, size=(5, 5), start=(2, 2), goal=(2, 3))
    assert np.argwhere(~grid.obstacles).tolist() == [[2, 2], [2, 3]]


@pytest.mark.parametrize("density", [-0.1, 1.1, float("nan"), "many"])
def test_a_density_is_a_share(density: object) -> None:
    with pytest.raises(SettingsError, match=r"^map\.density: expected a number from 0 to 1; got "):
        load_map("random", density=density)


def test_its_name_has_the_density() -> None:
    assert load_map("random").name == "random-50x50-d0.2-s0"
