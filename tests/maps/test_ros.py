"""Maps of ROS: real ones as published, ends in metres or cells, the robot's radius, and what is wrong is named."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from acoexp import Grid, MapError, SettingsError
from acoexp.grid import Frame
from acoexp.maps.map_server import occupancy, parse_description
from acoexp.maps.pixels import read_pixels
from acoexp.maps.ros import Ros, inflated
from acoexp.parameters import build

DATA = Path(__file__).parent / "ros"
SANDBOX = {"start": [-1.475, -1.575], "goal": [1.025, 1.675]}
YAML = """image: yard.pgm
resolution: 0.5
origin: [-1.0, 10.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""
YARD = "P2\n4 3\n255\n254 254 254 254\n0 0 205 254\n254 254 254 254\n"
ENDS = {"start": [-0.9, 10.1], "goal": [-0.75, 11.25]}


@pytest.fixture
def yard(tmp_path: Path) -> Path:
    """Return a description beside its image."""
    (tmp_path / "yard.yaml").write_text(YAML, encoding="utf-8")
    (tmp_path / "yard.pgm").write_text(YARD, encoding="utf-8")
    return tmp_path / "yard.yaml"


def load(path: Path, **options: Any) -> Grid:
    """Load a map as the command line does, its parameters checked."""
    grid: Grid = build(Ros, {"path": str(path), **options}, "map.").load()
    return grid


def refusal(path: Path, **options: Any) -> str:
    with pytest.raises(MapError) as caught:
        load(path, **options)
    return str(caught.value).replace(f"{path.parent}/", "")


def counts(name: str) -> list[int]:
    """Return how many cells of a real map are unknown, free and occupied."""
    about = parse_description((DATA / name).read_text("utf-8"), name)
    values = occupancy(read_pixels(DATA / about.image, "image"), about)
    return [int((values == value).sum()) for value in (-1, 0, 100)]


def test_real_maps_have_the_cells_that_map_server_publishes() -> None:
    assert counts("testmap.yaml") == [0, 71, 29]
    assert counts("tb3_sandbox.yaml") == [138683, 7903, 870]
    assert (read_pixels(DATA / "testmap.pgm", "image")[..., 0] == 254).sum() == 71


def test_a_real_map_is_crossed_in_metres() -> None:
    grid = load(DATA / "tb3_sandbox.yaml", **SANDBOX)
    assert (grid.name, grid.start, grid.goal, grid.moves) == ("tb3_sandbox.yaml", (215, 170), (150, 220), "no_cut")
    assert grid.optimum_pair == (15, 50)
    assert grid.frame == Frame(rows=384, resolution=0.05, origin=(-10.0, -10.0), yaw=0.0)
    assert np.allclose(grid.frame.to_metres([grid.start, grid.goal]), list(SANDBOX.values()))
    assert load(DATA / "tb3_sandbox.yaml", start=[215, 170], goal=[150, 220], unit="cell").digest == grid.digest
    assert (~load(DATA / "tb3_sandbox.yaml", unknown="free", **SANDBOX).obstacles).sum() == 138683 + 7903


def test_a_robot_that_has_a_radius_keeps_away() -> None:
    grid = load(DATA / "tb3_sandbox.yaml", radius=0.22, **SANDBOX)
    assert (~grid.obstacles).sum() == 5259
    assert grid.optimum == pytest.approx(90.397, abs=5e-4)


def test_a_map_that_is_turned_is_planned_on_in_its_own_frame() -> None:
    cells = [(2, 1), (8, 4)]
    turned = Frame(rows=10, resolution=0.1, origin=(2.0, 3.0), yaw=1.0).to_metres(cells).tolist()
    grid = load(DATA / "testmap.yaml", start=turned[0], goal=turned[1])
    assert [grid.start, grid.goal] == cells
    said = refusal(DATA / "testmap.yaml", start=[2.5, 3.5], goal=turned[1])
    assert said == (
        "map.start: expected metres in the rectangle [2, 3], [2.5403, 3.84147], [1.69883, 4.38177], "
        "[1.15853, 3.5403], which map testmap.yaml covers; got [2.5, 3.5]"
    )


def test_y_counts_from_the_bottom(yard: Path) -> None:
    grid = load(yard, **ENDS)
    assert grid.obstacles.astype(int).tolist() == [[0, 0, 0, 0], [1, 1, 1, 0], [0, 0, 0, 0]]
    assert (grid.start, grid.goal) == ((2, 0), (0, 0))


@pytest.mark.parametrize(("unknown", "blocked"), [("blocked", 3), ("free", 2)])
def test_unknown_cells_are_as_one_asks(yard: Path, unknown: str, blocked: int) -> None:
    assert load(yard, unknown=unknown, **ENDS).obstacles.sum() == blocked


@pytest.mark.parametrize("mode", ["scale", "raw"])
def test_what_lies_between_free_and_occupied_is_blocked_whatever_unknown_is(yard: Path, mode: str) -> None:
    yard.write_text(YAML + f"mode: {mode}\n", encoding="utf-8")
    free, between = ("254", "150") if mode == "scale" else ("19", "20")
    yard.with_name("yard.pgm").write_text(YARD.replace("254", free).replace("205", between), encoding="utf-8")
    if mode == "raw":
        yard.with_name("yard.pgm").write_text(
            f"P2\n4 3\n255\n{f'{free} ' * 4}99 99 {between} {free} " + f"{free} " * 4
        )
    assert load(yard, unknown="free", **ENDS).obstacles.sum() == 3


@given(
    arrays(bool, st.tuples(st.integers(1, 7), st.integers(1, 7))),
    st.sampled_from([0.0, 1.0, 1.5, 2.0, 5**0.5, 9.0]),
)
def test_inflation_blocks_what_is_no_farther_than_the_radius(blocked: np.ndarray, radius: float) -> None:
    rows, cols = np.indices(blocked.shape)
    expected = blocked.copy()
    for row, col in np.argwhere(blocked):
        expected |= (rows - row) ** 2 + (cols - col) ** 2 <= radius**2 + 1e-9
    assert (inflated(blocked, radius) == expected).all()


def test_a_radius_of_whole_cells_is_not_lost_in_rounding() -> None:
    assert 0.15 / 0.05 < 3.0
    assert inflated(np.array([[1, 0, 0, 0, 0]], bool), 0.15 / 0.05).tolist() == [[True, True, True, True, False]]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"start": [-0.75, 10.75]},
         "map yard.yaml: start [-0.75, 10.75] is an obstacle; the nearest free cell is 0.5 m away, at [-0.75, "),
        ({"start": [0.3, 10.7]},
         "map yard.yaml: start [0.3, 10.7] is unknown; the nearest free cell is 0.5 m away, at [0.25, 11.25]"),
        ({"goal": [1, 1], "start": [0, 0], "unit": "cell"},
         "map yard.yaml: goal [1, 1] is an obstacle; the nearest free cell is 0.5 m away, at [0, 1]"),
        ({"radius": 0.5},
         "map yard.yaml: start [-0.9, 10.1] is no farther than map.radius=0.5 from what is blocked; the nearest "
         "free cell is 1.5 m away, at [0.75, 10.25]"),
        ({"radius": 9},
         "map yard.yaml: start [-0.9, 10.1] is no farther than map.radius=9 from what is blocked; and no cell of "
         "the map is free"),
        ({"goal": [9, -3.5]},
         "map.goal: expected metres, x from -1 to 1 and y from 10 to 11.5, which map yard.yaml covers; got [9, "),
        ({"goal": [1e308, -1e308]}, "map.goal: expected metres, x from -1 to 1 and y from 10 to 11.5, which map "),
        ({"start": [0, 0], "goal": [3, 0], "unit": "cell"},
         "map.goal: expected a cell from [0, 0] to [2, 3], which map yard.yaml covers; got [3, 0]"),
        ({"start": [0, 0.5], "unit": "cell"}, "map.start: expected [row, column], whole numbers; got [0, 0.5]"),
        ({"goal": [-0.8, 10.2]}, "map yard.yaml: start and goal are one cell, (2, 0); expected two"),
    ],
)  # fmt: skip
def test_an_end_that_cannot_be_one_is_refused_in_the_unit_that_it_came_in(
    yard: Path, options: dict[str, Any], said: str
) -> None:
    assert refusal(yard, **{**ENDS, **options}).startswith(said)


@pytest.mark.parametrize("key", ["start", "goal"])
@pytest.mark.parametrize("odd", [None, [1], [1, "x"], 5, [float("nan"), 0], [True, 1]])
def test_ends_are_pairs_of_numbers(yard: Path, key: str, odd: Any) -> None:
    with pytest.raises(SettingsError, match=rf"^map\.{key}: expected a pair \[x, y\]; got "):
        load(yard, **{**ENDS, key: odd})


@pytest.mark.parametrize(
    "options", [{"radius": -1}, {"radius": float("inf")}, {"unit": "foot"}, {"unknown": "maybe"}]
)
def test_other_parameters_are_checked(yard: Path, options: dict[str, Any]) -> None:
    with pytest.raises(SettingsError, match=rf"^map\.{next(iter(options))}: expected "):
        load(yard, **ENDS, **options)


def test_an_image_lies_beside_its_description_or_where_that_says(yard: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir("/")
    digest = load(yard, **ENDS).digest
    other = yard.parent / "else" / "~a b"
    other.parent.mkdir()
    yard.with_name("yard.pgm").rename(other)
    for image in ("else/~a b", str(other)):
        yard.write_text(YAML.replace("yard.pgm", f"'{image}'"), encoding="utf-8")
        assert load(yard, **ENDS).digest == digest


def test_an_image_that_is_none_is_named(yard: Path) -> None:
    image = yard.with_name("yard.pgm")
    image.unlink()
    begin = "map yard.yaml: image: expected "
    assert refusal(yard, **ENDS) == f"{begin}a readable image; got 'yard.pgm' (No such file or directory)"
    os.mkfifo(image)
    assert refusal(yard, **ENDS) == f"{begin}a readable image; got 'yard.pgm' (a pipe)"
    image.unlink()
    image.write_text(YARD[:20], encoding="utf-8")
    assert refusal(yard, **ENDS).startswith(f"{begin}an image that can be decoded, PNG, PGM, ")
    image.write_text("P5\n10000 10000\n255\n", encoding="utf-8")
    assert refusal(yard, **ENDS).startswith(f"{begin}an image of at most 67 megapixels; got 'yard.pgm' (10000 x ")
    image.write_text("P5\n5000 5000\n255\n", encoding="utf-8")
    assert refusal(yard, **ENDS).startswith(f"{begin}an image of at most 17 million cells, each of 1 x 1 pixels; ")
    yard.write_text(YAML.replace("yard.pgm", '"a\\0b"'), encoding="utf-8")
    assert refusal(yard, **ENDS).startswith(f"{begin}a readable image; got ")


def test_a_description_that_is_none_is_named(yard: Path) -> None:
    assert refusal(yard.with_name("no.yaml"), **ENDS).startswith("map.path: expected a readable text file; got ")
    assert refusal(yard.parent, **ENDS).endswith("(a folder)")
    assert refusal(yard.with_name("yard.pgm"), **ENDS).startswith("map yard.pgm: expected map_server's YAML")
