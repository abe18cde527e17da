"""``map=rooms``: rooms of one side, a door in some walls, a way from each room to each."""

from __future__ import annotations

import numpy as np
import pytest
from reference import moves_of
from samples import reach_of
from scipy.ndimage import label

from acoexp import SettingsError, load_map


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("doors", [0.0, 0.5, 1.0])
def test_a_way_leads_into_every_room(doors: float, seed: int) -> None:
    grid = load_map("rooms", size=(31, 47), doors=doors, seed=seed, moves="four")
    allowed = moves_of(grid)
    assert reach_of(allowed, grid.start) == allowed.keys()
    assert {
        (row, col) for row in range(31) for col in range(47) if row % 8 != 7 and col % 8 != 7
    } <= allowed.keys()


@pytest.mark.parametrize(("doors", "number"), [(0.0, 23), (1.0, 38)])
@pytest.mark.parametrize("door", [1, 3, 7])
def test_each_wall_has_one_door_or_none(doors: float, number: int, door: int) -> None:
    """24 rooms, 4 by 6, have 38 walls between them, and 23 doors join them all."""
    obstacles = load_map("rooms", size=(31, 47), doors=doors, door=door).obstacles
    walls = np.zeros((31, 47), dtype=bool)
    walls[7::8], walls[:, 7::8] = True, True
    cut, count = label(walls & ~obstacles)
    assert count == number
    assert (np.bincount(cut.ravel())[1:] == door).all()
    assert not (obstacles & ~walls).any()
    assert obstacles[7::8, 7::8].all()


def test_doors_are_anywhere_in_a_wall() -> None:
    seen = {
        int(np.flatnonzero(~load_map("rooms", size=(7, 15), seed=seed).obstacles[:, 7])[0]) for seed in range(80)
    }
    assert seen == set(range(7))


def test_the_last_rooms_take_what_is_left_over() -> None:
    obstacles = load_map("rooms", size=(20, 20), side=5, doors=1.0).obstacles
    assert np.flatnonzero(obstacles.sum(axis=1) > 10).tolist() == [5, 11]
    assert np.flatnonzero(obstacles.sum(axis=0) > 10).tolist() == [5, 11]


@pytest.mark.parametrize("parameters", [{"side": 0}, {"door": 0}, {"doors": 2.0}, {"side": 3, "door": 4}])
def test_what_makes_no_rooms_is_refused(parameters: dict[str, float]) -> None:
    with pytest.raises(SettingsError, match=r"^map\.(side|door|doors): expected a"):
        load_map("rooms", **parameters)


def test_its_name_has_sides_and_doors() -> None:
    assert load_map("rooms").name == "rooms-50x50-r7-w1-d0.5-s0"
