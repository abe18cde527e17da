"""The potential field: where its force pulls a robot (Eqs 1-5 of the paper)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from reference import Colony, forces_of
from samples import grids

from acoexp import Grid, SettingsError
from acoexp.grid import DIRECTIONS
from acoexp.grid.field import NO_DIRECTION, FieldSettings, PotentialField, potential_field, sectors
from acoexp.parameters import build

E, NE, N, NW, W, SW, S, SE = range(8)
BLIND: dict[str, Any] = {"attraction": 0.0}
"""Settings under which obstacles push and the goal does not pull."""


def field_of(grid: Grid, settings: FieldSettings) -> PotentialField:
    """Return the field of a map."""
    return potential_field(grid.obstacles, grid.goal, settings)


def force_of(walls: NDArray[np.bool_], **constants: Any) -> NDArray[np.float64]:
    """Return the force on each cell of a map, float[rows, cols, 2] as (right, up)."""
    return field_of(Grid(walls), FieldSettings(**constants)).force


def with_obstacles(*cells: tuple[int, int]) -> NDArray[np.bool_]:
    """Return an open map, 9 x 9, with obstacles on some cells."""
    obstacles = np.zeros((9, 9), dtype=bool)
    obstacles[tuple(np.transpose(cells))] = True
    return obstacles


def test_attraction_alone_points_to_the_goal() -> None:
    grid = Grid(np.zeros((9, 9)), goal=(4, 4), start=(0, 0))
    sector = field_of(grid, FieldSettings()).sector
    around = {(4 - 3 * down, 4 - 3 * right): d for d, (down, right) in enumerate(DIRECTIONS)}
    assert {cell: int(sector[cell]) for cell in around} == around


def test_attraction_grows_in_proportion_to_the_distance() -> None:
    """Eq. 2: U = K_a d^2 / 2, so the force is K_a d."""
    force = force_of(np.zeros((9, 9), dtype=bool), attraction=2.5)
    assert force[8, 0].tolist() == [2.5 * 8, 0.0]
    assert force[0, 8].tolist() == [0.0, -2.5 * 8]
    assert np.hypot(*force[0, 0]) == pytest.approx(2.5 * math.hypot(8, 8))


@pytest.mark.parametrize("direction", range(8))
def test_an_obstacle_pushes_away_along_the_line(direction: int) -> None:
    down, right = DIRECTIONS[direction]
    force = force_of(with_obstacles((4, 4)), **BLIND)[4 + 2 * down, 4 + 2 * right]
    distance = 2 * math.hypot(down, right)
    strength = 25.0 * (1 / distance - 1 / 4.0) / distance**2
    assert force == pytest.approx(strength * np.array([right, -down]) / math.hypot(down, right))


def test_an_obstacle_does_not_push_beyond_its_reach() -> None:
    force = force_of(with_obstacles((4, 4)), **BLIND, reach=2.5)
    pushed = np.hypot(*np.moveaxis(force, -1, 0)) > 0
    row, col = np.indices(pushed.shape) - 4
    assert (pushed == ((np.hypot(row, col) > 0) & (np.hypot(row, col) < 2.5))).all()


def test_the_pushes_of_obstacles_add_up() -> None:
    walls = (2, 2), (3, 5), (6, 4)
    apart = np.sum([force_of(with_obstacles(wall), **BLIND) for wall in walls], axis=0)
    together = force_of(with_obstacles(*walls), **BLIND)
    free = ~with_obstacles(*walls)
    np.testing.assert_allclose(together[free], apart[free], atol=1e-12)


def test_the_border_of_the_map_does_not_push() -> None:
    assert not force_of(np.zeros((9, 9), dtype=bool), **BLIND).any()


def test_obstacles_carry_no_force() -> None:
    obstacles = with_obstacles((3, 3), (3, 4), (6, 6))
    field = field_of(Grid(obstacles), FieldSettings())
    assert not field.force[obstacles].any()
    assert (field.sector[obstacles] == NO_DIRECTION).all()


def test_of_the_obstacles_only_the_nearest_pushes_if_so_chosen() -> None:
    near, far = (2, 2), (6, 4)
    force = force_of(with_obstacles(near, far), **BLIND, obstacles="nearest")
    assert force[3, 3] == pytest.approx(force_of(with_obstacles(near), **BLIND)[3, 3])
    assert force[7, 4] == pytest.approx(force_of(with_obstacles(far), **BLIND)[7, 4])


def test_obstacles_that_are_equally_near_push_by_their_mean() -> None:
    beside, below = (4, 2), (6, 4)
    apart = [force_of(with_obstacles(wall), **BLIND)[4, 4] for wall in (beside, below)]
    both = force_of(with_obstacles(beside, below), **BLIND, obstacles="nearest")[4, 4]
    assert both == pytest.approx(np.mean(apart, axis=0))


@given(grids(12), st.floats(0, 10), st.floats(0, 100), st.floats(0.1, 20), st.sampled_from(["sum", "nearest"]))
@settings(max_examples=80, deadline=None)
def test_the_force_is_that_of_plain_loops(
    grid: Grid, attraction: float, repulsion: float, reach: float, obstacles: str
) -> None:
    constants: dict[str, Any] = {"attraction": attraction, "repulsion": repulsion}
    constants |= {"reach": reach, "obstacles": obstacles}
    force = field_of(grid, FieldSettings(**constants)).force
    for cell, expected in forces_of(grid, Colony("pd", **constants)).items():
        assert force[cell] == pytest.approx(expected, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("obstacles", ["sum", "nearest"])
def test_it_does_not_matter_in_which_strips_a_map_is_worked_through(
    obstacles: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Bit for bit; the reach is beyond a strip, and beyond the map."""
    walls = np.random.default_rng(3).random((23, 17)) < 0.3
    for reach in (4.0, 30.0):
        constants = FieldSettings(reach=reach, obstacles=obstacles)
        whole = potential_field(walls, (20, 3), constants)
        for cells in (1, 40, 23 * 17):
            monkeypatch.setattr("acoexp.grid.field._STRIP", cells)
            found = potential_field(walls, (20, 3), constants)
            assert np.array_equal(found.force, whole.force)
            assert np.array_equal(found.sector, whole.sector)


@given(st.integers(-7200, 7200).filter(lambda tenths: tenths % 450 != 225), st.floats(1e-6, 1e6))
def test_a_sector_reaches_half_a_sector_to_both_sides_of_its_direction(tenths: int, strength: float) -> None:
    """Sector j holds (j - 1) pi/4 +- pi/8, j from 1: here from 0, whatever range the angle comes in."""
    theta = math.radians(tenths / 10)
    sector = int(sectors(strength * np.array([math.cos(theta), math.sin(theta)])))
    off = (tenths / 10 - 45 * sector + 180) % 360 - 180
    assert abs(off) < 22.5


@pytest.mark.parametrize(
    ("angle", "below", "above"), [(22.5, E, NE), (67.5, NE, N), (-22.5, SE, E), (202.5, W, SW)]
)
def test_sectors_meet_halfway_between_two_directions(angle: float, below: int, above: int) -> None:
    around = np.radians([angle - 1e-6, angle + 1e-6])
    assert sectors(np.stack([np.cos(around), np.sin(around)], axis=-1)).tolist() == [below, above]


@pytest.mark.parametrize("force", [(-1.0, 0.0), (-1.0, -0.0), (-1.0, 1e-300), (-1.0, -1e-300)])
def test_west_is_one_sector_on_both_sides_of_the_angle_pi(force: tuple[float, float]) -> None:
    assert sectors(np.array(force)) == W


def test_no_force_has_no_direction() -> None:
    assert sectors(np.array([[0.0, 0.0], [-0.0, 0.0]])).tolist() == [NO_DIRECTION] * 2
    off = FieldSettings(attraction=0.0, repulsion=0.0)
    assert (field_of(Grid(with_obstacles((4, 4))), off).sector == NO_DIRECTION).all()


def test_at_the_goal_nothing_attracts() -> None:
    field = field_of(Grid(np.zeros((5, 5))), FieldSettings())
    assert field.sector[4, 4] == NO_DIRECTION


def test_pushes_that_cancel_have_no_direction() -> None:
    """In the middle of a closed room all pushes come in opposite pairs."""
    room = np.ones((7, 7), dtype=bool)
    room[1:-1, 1:-1] = False
    grid = Grid(room, start=(1, 1), goal=(5, 5))
    assert field_of(grid, FieldSettings(**BLIND)).sector[3, 3] == NO_DIRECTION


@pytest.mark.parametrize(
    "values",
    [{"attraction": -1}, {"repulsion": -0.1}, {"reach": 0}, {"reach": math.nan}, {"obstacles": "farthest"}],
)
def test_constants_out_of_range_are_refused(values: dict[str, object]) -> None:
    with pytest.raises(SettingsError, match=f"field.{next(iter(values))}: expected "):
        build(FieldSettings, values, "field.")
