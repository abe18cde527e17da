"""A trial's path for programs: each cell's place in the plane, and the message of ROS that it makes."""

from __future__ import annotations

import csv
import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from acoexp import Grid, Result
from acoexp.command.results.paths import write_path
from acoexp.grid.frame import Frame
from acoexp.grid.moves import DIRECTIONS, follow

E, NE, N, NW, W, SW, S, SE = range(8)

SHAPE = (4, 6)
START, ROUND = (2, 1), [E, NE, N, NW, W, SW, S, SE, E, SE]
"""A path in every direction: from (2, 1) once around, and on to (3, 4)."""


def result(frame: Frame | None, moves: list[int] | None = ROUND) -> Result:
    """Return a trial with a path of such moves, on free ground."""
    made = None if moves is None else np.array(moves, dtype=np.uint8)
    goal = (3, 5) if made is None else tuple(follow(START, made)[-1].tolist())
    grid = Grid(np.zeros(SHAPE), start=START, goal=goal, frame=frame)
    curve = np.full((1, 2), -1, dtype=np.int32)
    if moves is not None:
        curve[0] = sum(move % 2 == 0 for move in moves), sum(move % 2 for move in moves)
    lost, steps = np.zeros(1, dtype=np.int32), np.ones(1, dtype=np.int64)
    return Result(
        algo="nav",
        seed=0,
        grid=grid,
        moves=made,
        raw_moves=made,
        curve_pairs=curve,
        lost_ants=lost,
        cycle_steps=steps,
    )


def expected(
    moves: list[int], resolution: float, origin: tuple[float, float], yaw: float
) -> list[dict[str, float]]:
    """Return the rows of a path as a plain walk over its cells has them."""
    (row, col), length, rows = START, 0.0, []
    for move in [*moves, None]:
        across, along = col + 0.5, SHAPE[0] - row - 0.5
        x = origin[0] + resolution * (math.cos(yaw) * across - math.sin(yaw) * along)
        y = origin[1] + resolution * (math.sin(yaw) * across + math.cos(yaw) * along)
        rows.append({"x": x, "y": y, "length": length, "row": row, "col": col})
        if move is not None:
            row, col = row + DIRECTIONS[move][0], col + DIRECTIONS[move][1]
            length += resolution * math.hypot(*DIRECTIONS[move])
    for here, there in pairwise(rows):
        here["heading"] = math.atan2(there["y"] - here["y"], there["x"] - here["x"])
    rows[-1]["heading"] = rows[-2]["heading"]
    return rows


def rows_of(file: Path) -> list[dict[str, float]]:
    """Return a CSV's rows by the names in its heading, its unit left out."""
    with file.open(encoding="utf-8", newline="") as lines:
        return [{key.split("_")[0]: float(text) for key, text in row.items()} for row in csv.DictReader(lines)]


def turn(angle: float, other: float) -> float:
    """Return by how much two directions differ."""
    return abs(math.remainder(angle - other, math.tau))


def test_a_file_looks_like_this(tmp_path: Path) -> None:
    write_path(result(Frame(rows=4, resolution=0.5, origin=(-1.0, 2.0)), [NE, E]), tmp_path)
    assert (tmp_path / "path.csv").read_bytes().decode() == (
        "x_m,y_m,heading_rad,length_m,row,col\n"
        "-0.25,2.75,0.7853981633974483,0.0,2,1\n"
        "0.25,3.25,0.0,0.7071067811865476,1,2\n"
        "0.75,3.25,0.0,1.2071067811865475,1,3\n"
    )


@pytest.mark.parametrize("yaw", [0.0, 0.3, -2.5, math.pi, -math.pi, 7.0, 900.0])
def test_each_cell_is_a_place_in_metres(yaw: float, tmp_path: Path) -> None:
    write_path(result(Frame(rows=4, resolution=0.05, origin=(-10.0, 3.5), yaw=yaw)), tmp_path)
    found = rows_of(tmp_path / "path.csv")
    for here, there in zip(found, expected(ROUND, 0.05, (-10.0, 3.5), yaw), strict=True):
        assert here == pytest.approx({**there, "heading": here["heading"]}, abs=1e-12)
        assert -math.pi <= here["heading"] <= math.pi
        assert turn(here["heading"], there["heading"]) < 1e-9


def test_without_a_frame_the_unit_is_a_cell_from_the_lower_left_corner(tmp_path: Path) -> None:
    trial = result(None)
    write_path(trial, tmp_path)
    assert (tmp_path / "path.csv").read_text("utf-8").startswith("x_cell,y_cell,heading_rad,length_cell,row,col\n")
    found = rows_of(tmp_path / "path.csv")
    for here, there in zip(found, expected(ROUND, 1.0, (0.0, 0.0), 0.0), strict=True):
        assert here == pytest.approx(there, abs=1e-12)
    assert found[-1]["length"] == trial.length
    assert [path.name for path in tmp_path.iterdir()] == ["path.csv"]


@pytest.mark.parametrize("yaw", [0.0, 2.0])
def test_the_message_has_the_fields_of_nav_msgs_path(yaw: float, tmp_path: Path) -> None:
    write_path(result(Frame(rows=4, resolution=0.05, origin=(-10.0, 3.5), yaw=yaw)), tmp_path)
    header = {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "map"}
    message = yaml.safe_load((tmp_path / "path.yaml").read_text("utf-8"))
    assert list(message) == ["header", "poses"]
    assert message["header"] == header
    places = rows_of(tmp_path / "path.csv")
    for pose, place in zip(message["poses"], places, strict=True):
        orientation = pose["pose"]["orientation"]
        assert pose == {
            "header": header,
            "pose": {"position": {"x": place["x"], "y": place["y"], "z": 0.0}, "orientation": orientation},
        }
        assert list(orientation) == ["x", "y", "z", "w"]
        assert (orientation["x"], orientation["y"]) == (0.0, 0.0)
        assert math.hypot(orientation["z"], orientation["w"]) == pytest.approx(1.0)
        assert turn(2 * math.atan2(orientation["z"], orientation["w"]), place["heading"]) < 1e-12


@pytest.mark.parametrize("resolution", [1e-17, 1e9])
def test_every_number_of_the_message_is_one(resolution: float, tmp_path: Path) -> None:
    """YAML takes 1e-17 for a text."""

    def numbers(value: Any) -> list[Any]:
        inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else None
        return [value] if inner is None else [number for each in inner for number in numbers(each)]

    write_path(result(Frame(rows=4, resolution=resolution, origin=(0.0, 0.0))), tmp_path)
    poses = yaml.safe_load((tmp_path / "path.yaml").read_text("utf-8"))["poses"]
    assert {type(number) for pose in poses for number in numbers(pose["pose"])} == {float}


def test_where_no_ant_arrived_nothing_is_written(tmp_path: Path) -> None:
    write_path(result(Frame(rows=4, resolution=0.5), moves=None), tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_no_path_of_an_earlier_trial_stays(tmp_path: Path) -> None:
    for frame, moves, left in (
        (Frame(rows=4, resolution=0.5), ROUND, {"path.csv", "path.yaml"}),
        (None, ROUND, {"path.csv"}),
        (None, None, set()),
    ):
        write_path(result(frame, moves), tmp_path)
        assert {path.name for path in tmp_path.iterdir()} == left


def test_a_file_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "path.yaml").mkdir()
    with pytest.raises(OSError, match=r"path\.yaml"):
        write_path(result(Frame(rows=4, resolution=0.5)), tmp_path)
