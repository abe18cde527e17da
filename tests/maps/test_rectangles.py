"""``map=rectangles``: so many, of such sides, wholly on the map."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import find_objects, label

from acoexp import MapError, SettingsError, load_map
from acoexp.maps.rectangles import RectangleMap


def drawn(seed: int, **parameters: object) -> np.ndarray:
    """Return the obstacles of one draw, before both ends are kept free."""
    source = RectangleMap(seed=seed, **parameters)  # type: ignore[arg-type]
    return source.obstacles(np.random.Generator(np.random.PCG64(seed)))


def test_one_rectangle_is_one_of_the_sides_that_were_asked_for() -> None:
    seen = set()
    for seed in range(300):
        obstacles = drawn(seed, count=1, sides=(2, 4), size=(6, 9))
        (box,) = find_objects(label(obstacles)[0])
        assert obstacles[box].all()
        seen.add(obstacles[box].shape)
    assert seen == {(height, width) for height in (2, 3, 4) for width in (2, 3, 4)}


def test_rectangles_come_as_near_to_every_rim_as_to_the_middle() -> None:
    covered = np.mean([drawn(seed, count=1, sides=(1, 1), size=(4, 5)) for seed in range(4000)], axis=0)
    assert np.abs(covered - 1 / 20).max() < 0.02


def test_many_cover_what_they_would_one_by_one() -> None:
    rng = np.random.Generator(np.random.PCG64(5))
    sides = rng.integers(2, 5, size=(40, 2), endpoint=True)
    places = rng.random((40, 2))
    expected = np.zeros((30, 40), dtype=bool)
    for (height, width), (down, right) in zip(sides.tolist(), places.tolist(), strict=True):
        top, left = int(down * (30 - height + 1)), int(right * (40 - width + 1))
        expected[top : top + height, left : left + width] = True
    assert np.array_equal(drawn(5, count=40, sides=(2, 5), size=(30, 40)), expected)


def test_a_side_longer_than_the_map_is_as_long_as_the_map() -> None:
    assert drawn(0, count=1, sides=(9, 9), size=(4, 20)).sum() == 4 * 9
    with pytest.raises(MapError, match="it did on none of 100 maps"):
        load_map("rectangles", count=1, sides=(9, 9), size=(9, 9))


def test_no_rectangles_are_an_open_map() -> None:
    assert not load_map("rectangles", count=0).obstacles.any()


@pytest.mark.parametrize("sides", [(0, 3), (4, 3), (1, 2049)])
def test_sides_are_a_range(sides: tuple[int, int]) -> None:
    with pytest.raises(
        SettingsError, match=r"^map\.sides: expected the shortest and the longest side, from 1 to 2048"
    ):
        load_map("rectangles", sides=sides)


@pytest.mark.parametrize("count", [-1, 100_001, 0.5])
def test_a_count_is_bounded(count: object) -> None:
    with pytest.raises(SettingsError, match=r"^map\.count: expected a whole number from 0 to 100000; got "):
        load_map("rectangles", count=count)


def test_its_name_has_count_and_sides() -> None:
    assert load_map("rectangles").name == "rectangles-50x50-n30-l2-8-s0"
