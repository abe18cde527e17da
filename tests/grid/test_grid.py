"""The grid: what it accepts, what it refuses and why, and that it never changes."""

from __future__ import annotations

import math
import pickle
from dataclasses import FrozenInstanceError
from typing import Any

import numpy as np
import pytest
from samples import random_grid

from acoexp import Grid, MapError
from acoexp.grid import Frame
from acoexp.grid.any_angle import any_angle_length

OPEN = np.zeros((3, 4), dtype=int)
PATH = [(0, 0), (1, 1), (2, 2), (2, 3)]


def refusal(obstacles: Any, **options: Any) -> str:
    """Return the message with which a map is refused."""
    with pytest.raises(MapError) as caught:
        Grid(obstacles, **options)
    return str(caught.value)


def test_ends_are_the_corners_and_diagonals_do_not_squeeze_unless_told() -> None:
    grid = Grid(OPEN)
    assert (grid.start, grid.goal, grid.moves, grid.shape) == ((0, 0), (2, 3), "no_squeeze", (3, 4))


@pytest.mark.parametrize("dtype", [bool, np.uint8, np.int64, np.float32])
def test_any_array_of_zeros_and_ones_is_a_map(dtype: type) -> None:
    grid = Grid(np.array([[0, 1], [0, 0]], dtype=dtype))
    assert grid.obstacles.dtype == bool
    assert grid.obstacles.tolist() == [[False, True], [False, False]]


def test_nested_lists_are_a_map() -> None:
    assert Grid([[0, 1], [0, 0]]).obstacles.sum() == 1


@pytest.mark.parametrize("empty", [[], [[]], np.zeros((0, 5)), np.zeros((5, 0))])
def test_an_empty_map_is_refused(empty: Any) -> None:
    assert "expected an array [rows, cols] of 0 and 1; got shape (" in refusal(empty)


@pytest.mark.parametrize("shape", [(), (5,), (2, 3, 4)])
def test_a_map_has_two_dimensions(shape: tuple[int, ...]) -> None:
    assert f"got shape {shape}" in refusal(np.zeros(shape))


def test_a_ragged_map_is_refused() -> None:
    assert "rows of one length" in refusal([[0, 0], [0]])


@pytest.mark.parametrize("odd", [2, -1, 0.5, np.nan, np.inf, "0", None, 1j])
def test_anything_but_zero_and_one_is_refused(odd: Any) -> None:
    assert "expected only 0 (free) and 1 (obstacle)" in refusal([[0, odd], [0, 0]])


@pytest.mark.parametrize("key", ["start", "goal"])
@pytest.mark.parametrize("cell", [(3, 0), (0, 4), (-1, 0), (0, -1)])
def test_start_and_goal_lie_inside(key: str, cell: tuple[int, int]) -> None:
    message = refusal(OPEN, name="yard", **{key: cell})
    assert message == f"map yard: {key} {cell} lies outside; expected a cell from (0, 0) to (2, 3)"


@pytest.mark.parametrize("key", ["start", "goal"])
def test_start_and_goal_are_free(key: str) -> None:
    assert f"{key} (1, 1) is an obstacle" in refusal([[0, 0, 0], [0, 1, 0], [0, 0, 0]], **{key: (1, 1)})


@pytest.mark.parametrize("key", ["start", "goal"])
@pytest.mark.parametrize(
    "odd", [(0.0, 1.0), (1.5, 1), (True, 2), (1, 2, 3), (1,), "ab", 5, (None, 1), np.zeros((2, 2), int)]
)
def test_start_and_goal_are_pairs_of_whole_numbers(key: str, odd: Any) -> None:
    assert f"{key}: expected (row, column), whole numbers; got {odd!r}" in refusal(OPEN, **{key: odd})


def test_start_and_goal_may_be_numpy_numbers_and_become_plain_ones() -> None:
    grid = Grid(OPEN, start=np.array([0, 1]), goal=(np.int8(2), np.uint64(0)))  # type: ignore[arg-type]
    assert (grid.start, grid.goal) == ((0, 1), (2, 0))
    assert all(type(number) is int for number in grid.start + grid.goal)


def test_start_and_goal_are_two_cells() -> None:
    assert "start and goal are one cell, (1, 1); expected two" in refusal(OPEN, start=(1, 1), goal=(1, 1))
    assert "are one cell, (0, 0)" in refusal([[0]])


def test_a_way_must_lead_from_start_to_goal() -> None:
    message = refusal([[0, 1, 0], [0, 1, 0]], name="wall")
    assert message.startswith(
        "map wall: no way leads from start (0, 0) to goal (1, 2) under the rule 'no_squeeze'"
    )


def test_whether_there_is_a_way_depends_on_the_rule() -> None:
    squeeze, cut = [[0, 1], [1, 0]], [[0, 1], [0, 0]]
    assert Grid(squeeze, moves="free").optimum_pair == (0, 1)
    assert "no way" in refusal(squeeze, moves="no_squeeze")
    assert Grid(cut, moves="no_squeeze").optimum_pair == (0, 1)
    assert Grid(cut, moves="no_cut").optimum_pair == (2, 0)
    assert Grid([[0, 0], [0, 0]], moves="no_cut").optimum_pair == (0, 1)
    assert Grid([[0, 0], [0, 0]], moves="four").optimum_pair == (2, 0)


def test_without_diagonals_a_path_that_has_one_is_refused() -> None:
    grid = Grid([[0, 0], [0, 0]], moves="four")
    assert grid.measure([(0, 0), (1, 0), (1, 1)]) == (2, 0)
    with pytest.raises(MapError, match=r"move 1 of a path.* is not allowed under the rule 'four'"):
        grid.measure([(0, 0), (1, 1)])


@pytest.mark.parametrize("rule", ["diagonal", "", None, "FREE"])
def test_an_unknown_rule_is_refused(rule: Any) -> None:
    message = refusal(OPEN, moves=rule)
    assert "expected one of: free, no_squeeze, no_cut, four" in message
    assert f"got {rule!r}" in message


def test_a_map_that_is_too_large_for_the_memory_is_refused() -> None:
    vast = np.broadcast_to(np.zeros(1, bool), (2**30, 2**30))
    assert refusal(vast, name="yard") == (
        "map yard: expected a map for which the memory suffices; got shape (1073741824, 1073741824)"
    )


def test_the_array_given_is_copied() -> None:
    given = np.zeros((3, 3), dtype=bool)
    grid = Grid(given)
    given[1, 1] = True
    assert not grid.obstacles.any()


def test_a_grid_never_changes() -> None:
    grid = Grid(OPEN)
    with pytest.raises(ValueError, match=r"read-only"):
        grid.obstacles[0, 1] = True
    with pytest.raises(ValueError, match=r"read-only"):
        grid.allowed[0, 1] = 0
    with pytest.raises(FrozenInstanceError):
        grid.start = (1, 1)  # type: ignore[misc]


def test_a_grid_sent_to_another_process_does_not_change_either() -> None:
    assert not pickle.loads(pickle.dumps(Grid(OPEN))).obstacles.flags.writeable


@pytest.mark.parametrize(
    "other",
    [
        Grid([[0, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 0]]),
        Grid(OPEN, start=(0, 1)),
        Grid(OPEN, goal=(2, 2)),
        Grid(OPEN, moves="free"),
        Grid(OPEN.T, goal=(2, 2)),
        Grid(np.zeros((3, 5)), goal=(2, 3)),
    ],
)
def test_the_digest_changes_with_everything_a_planner_sees(other: Grid) -> None:
    assert other.digest != Grid(OPEN).digest


def test_the_digest_does_not_change_with_name_remarks_and_frame() -> None:
    other = Grid(OPEN, name="other", metadata={"origin": "here"}, frame=Frame(rows=3, resolution=0.05))
    assert other.digest == Grid(OPEN.astype(bool)).digest


def test_a_frame_is_kept_and_sent_along_if_it_is_one_for_the_map() -> None:
    frame = Frame(rows=3, resolution=0.05, origin=(-10.0, 2.0), yaw=0.5)
    assert Grid(OPEN).frame is None
    assert pickle.loads(pickle.dumps(Grid(OPEN, frame=frame))).frame == frame
    said = refusal(OPEN, frame=Frame(rows=4, resolution=0.05))
    assert said == "map array: frame: expected one of 3 rows; got one of 4"


@pytest.mark.parametrize(
    "path", [PATH, np.array(PATH), np.array(PATH, np.uint8), np.array(PATH)[::-1][::-1], np.array([PATH, PATH])[1]]
)
def test_a_path_is_measured_in_straight_and_diagonal_moves(path: Any) -> None:
    assert Grid(OPEN).measure(path) == (1, 2)


@pytest.mark.parametrize(
    ("path", "complaint"),
    [
        ([(0, 0), (2, 2), (2, 3)], "move 1 of a path, from (0, 0) to (2, 2), is not allowed"),  # a jump
        ([(0, 0), (0, 0), (1, 1), (2, 2), (2, 3)], "move 1 of a path, from (0, 0) to (0, 0)"),  # standing still
        ([(0, 0), (-1, 1), (0, 2), (1, 3), (2, 3)], "move 1 of a path, from (0, 0) to (-1, 1)"),  # outside
        ([(0, 0), (1, 1), (2, 2), (3, 3), (2, 3)], "move 3 of a path, from (2, 2) to (3, 3)"),
        ([(0, 0), (1, 1), (2, 2)], "expected a path from (0, 0) to (2, 3); got one from (0, 0) to (2, 2)"),
        (PATH[::-1], "got one from (2, 3) to (0, 0)"),
        ([(0, 0)], "expected a path int[n, 2], n >= 2; got int64 of shape (1, 2)"),
        ([0, 1, 2], "got int64 of shape (3,)"),
        ([(0, 0, 0), (2, 3, 0)], "got int64 of shape (2, 3)"),
        (None, "got object of shape ()"),
    ],
)
def test_what_is_no_path_is_refused(path: Any, complaint: str) -> None:
    with pytest.raises(MapError) as caught:
        Grid(OPEN, name="yard").measure(path)
    assert str(caught.value).startswith("map yard: ")
    assert complaint in str(caught.value)


def test_an_unsigned_path_may_lead_up_and_left() -> None:
    assert Grid(OPEN, start=(2, 3), goal=(0, 0)).measure(np.array(PATH, np.uint8)[::-1]) == (1, 2)


@pytest.mark.parametrize("path", [np.array(PATH, float), [(0, 0), (1, 1), (2,)]])
def test_a_path_of_floats_or_ragged_is_refused(path: Any) -> None:
    with pytest.raises(MapError, match=r"expected a path int"):
        Grid(OPEN).measure(path)


def test_a_path_across_an_obstacle_or_past_its_corner_is_refused() -> None:
    grid = Grid([[0, 1, 0], [0, 0, 0]], moves="no_cut")
    for path in ([(0, 0), (0, 1), (1, 2)], [(0, 0), (1, 1), (1, 2)]):
        with pytest.raises(MapError, match=r"move 1 of a path.* is not allowed under the rule 'no_cut'"):
            grid.measure(path)
    assert grid.measure([(0, 0), (1, 0), (1, 1), (1, 2)]) == (3, 0)


def test_the_clearance_of_a_cell_is_the_distance_of_the_nearest_obstacles_centre() -> None:
    grid = random_grid(3, 9, 14, "free")
    walls = np.argwhere(grid.obstacles)
    for cell in np.ndindex(grid.shape):
        nearest = min(math.dist(cell, wall) for wall in walls.tolist())
        assert grid.clearance[cell] == pytest.approx(nearest, abs=1e-12)
    assert np.isnan(Grid(OPEN).clearance).all()


@pytest.mark.parametrize(("moves", "squeezes"), [("free", True), ("no_squeeze", False), ("no_cut", False)])
def test_an_any_angle_path_squeezes_where_a_move_does(moves: str, squeezes: bool) -> None:
    grid = Grid([[0, 1, 0], [0, 0, 1], [0, 0, 0], [1, 0, 0]], start=(0, 0), goal=(3, 2), moves=moves)
    length = any_angle_length(grid.obstacles, (0, 0), (3, 2), squeezes)
    assert grid.any_angle_optimum == pytest.approx(length)
