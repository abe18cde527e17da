"""Floor plans: dark is blocked, pixels are pooled, dots mark the ends, and what is wrong is named."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from PIL import Image as Pillow

from acoexp import Grid, MapError, SettingsError
from acoexp.maps.image import Image, _pooled
from acoexp.parameters import build

WHITE, BLACK, GREEN, RED = (255, 255, 255), (0, 0, 0), (0, 200, 0), (220, 20, 20)
COLOURS = {".": WHITE, "#": BLACK, "s": GREEN, "g": RED}
PLAN = """
........
.ss..#..
.ss..#..
.....#..
......g.
........
"""


def drawn(path: Path, plan: str = PLAN) -> Path:
    """Write a plan as an image, a sign a pixel."""
    rows = [[COLOURS[sign] for sign in line] for line in plan.split()]
    Pillow.fromarray(np.array(rows, dtype=np.uint8)).save(path)
    return path


@pytest.fixture
def plan(tmp_path: Path) -> Path:
    """Return an image's file."""
    return drawn(tmp_path / "plan.png")


def load(path: Path, **options: Any) -> Grid:
    """Load a map as the command line does, its parameters checked."""
    grid: Grid = build(Image, {"path": str(path), **options}, "map.").load()
    return grid


def refusal(path: Path, **options: Any) -> str:
    with pytest.raises(MapError) as caught:
        load(path, **options)
    return str(caught.value).replace(f"{path.parent}/", "")


def test_dark_is_blocked_and_dots_are_the_ends(plan: Path) -> None:
    grid = load(plan)
    assert (grid.name, grid.shape, grid.moves, grid.frame) == ("plan.png", (6, 8), "no_cut", None)
    assert np.argwhere(grid.obstacles).tolist() == [[1, 5], [2, 5], [3, 5]]
    assert (grid.start, grid.goal) == ((1, 1), (4, 6))


def test_where_an_end_is_given_no_dot_is_looked_for_and_colours_are_as_dark_as_others(plan: Path) -> None:
    grid = load(plan, start=[0, 0], goal=[0, 7])
    assert (grid.start, grid.goal) == ((0, 0), (0, 7))
    assert grid.obstacles[1:3, 1:3].all()
    assert grid.obstacles[4, 6]
    assert not load(plan, start=[0, 0]).obstacles[4, 6]


def test_pixels_are_pooled_and_at_the_edges_a_cell_may_have_fewer(plan: Path) -> None:
    grid = load(plan, scale=2)
    assert grid.obstacles.astype(int).tolist() == [[0, 0, 1, 0], [0, 0, 1, 0], [0, 0, 0, 0]]
    assert (grid.start, grid.goal) == ((0, 0), (2, 3))
    assert load(plan, scale=5, goal=[5, 7]).obstacles.tolist() == [[False, True], [False, False]]


@given(arrays(bool, st.tuples(st.integers(1, 9), st.integers(1, 9))), st.integers(1, 11))
def test_a_cell_is_blocked_if_any_of_its_pixels_is_dark(dark: np.ndarray, scale: int) -> None:
    rows, cols = (-(-size // scale) for size in dark.shape)
    expected = [
        [dark[r * scale : (r + 1) * scale, c * scale : (c + 1) * scale].any() for c in range(cols)]
        for r in range(rows)
    ]
    assert _pooled(dark, scale).tolist() == expected


@pytest.mark.parametrize(
    ("threshold", "blocked"), [(0.0, []), (0.1, [0]), (0.5, [0, 1]), (0.51, [0, 1, 2]), (1.0, 3)]
)
def test_a_pixel_is_dark_if_the_mean_of_its_channels_is_below_the_threshold(
    tmp_path: Path, threshold: float, blocked: Any
) -> None:
    shades = [(0, 0, 0), (90, 140, 140), (128, 130, 126), (254, 255, 255)]
    Pillow.fromarray(np.array([shades, [WHITE] * 4], dtype=np.uint8)).save(tmp_path / "plan.png")
    grid = load(tmp_path / "plan.png", start=[1, 0], goal=[1, 3], threshold=threshold)
    assert np.flatnonzero(grid.obstacles[0]).tolist() == (blocked if isinstance(blocked, list) else [0, 1, 2, 3])


def test_where_an_image_is_transparent_it_is_white(tmp_path: Path) -> None:
    pixels = np.array(
        [[(0, 0, 0, 0), (0, 0, 0, 255), (0, 0, 0, 100), (0, 255, 0, 60)], [(0, 0, 0, 0)] * 4], np.uint8
    )
    Pillow.fromarray(pixels).save(tmp_path / "plan.png")
    grid = load(tmp_path / "plan.png", start=[1, 0], goal=[1, 3])
    assert grid.obstacles.astype(int).tolist() == [[0, 1, 0, 0], [0, 0, 0, 0]]


@pytest.mark.parametrize(
    ("colour", "marks"),
    [((0, 128, 0), "start"), ((34, 177, 76), "start"), ((0, 255, 127), "start"), ((237, 28, 36), "goal"),
     ((128, 64, 0), "goal"), ((0, 127, 0), None), ((0, 255, 128), None), ((255, 165, 0), None)],
)  # fmt: skip
def test_a_colour_is_a_dots_from_half_strength_on_at_twice_each_other_channel(
    tmp_path: Path, colour: tuple[int, int, int], marks: str | None
) -> None:
    Pillow.fromarray(np.array([[WHITE, colour, WHITE]], dtype=np.uint8)).save(tmp_path / "plan.png")
    for key, other in (("start", "goal"), ("goal", "start")):
        if key == marks:
            assert getattr(load(tmp_path / "plan.png", **{other: [0, 0]}), key) == (0, 1)
        else:
            assert refusal(tmp_path / "plan.png", **{other: [0, 0]}).endswith("dot; got neither")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("g", ".", "map plan.png: expected map.goal as [row, column] in pixels, or one red dot; got neither"),
        ("s", ".", "map plan.png: expected map.start as [row, column] in pixels, or one green dot; got neither"),
        ("........\n.ss", "g.......\n.ss", "map plan.png: expected map.goal as [row, column] in pixels, or one "
         "red dot; got 2 separate ones"),
    ],
)  # fmt: skip
def test_a_dot_that_is_missing_or_not_the_only_one_is_named(plan: Path, old: str, new: str, said: str) -> None:
    assert refusal(drawn(plan, PLAN.replace(old, new))) == said


def test_a_dot_touches_itself_at_corners_too(plan: Path) -> None:
    assert load(drawn(plan, "s...\n..g.\n.g.#\n")).goal == (1, 1)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"start": [2, 5]}, "map plan.png: start [2, 5] is an obstacle; the nearest free cell is 1 pixels away, "),
        ({"scale": 2, "start": [2, 4]}, "map plan.png: start [2, 4] is in a cell of 2 x 2 pixels with a dark one; "
         "the nearest free cell is 2 pixels away, at [2, 6]"),
        ({"goal": [6, 0]}, "map.goal: expected a pixel from [0, 0] to [5, 7], which map plan.png covers; got [6"),
        ({"goal": [0, -1]}, "map.goal: expected a pixel from [0, 0] to [5, 7]"),
        ({"scale": 10**4}, "map plan.png: start [1, 1] is in a cell of 10000 x 10000 pixels with a dark one; "),
        ({"start": [4, 6]}, "map plan.png: start and goal are one cell, (4, 6); expected two"),
    ],
)  # fmt: skip
def test_an_end_that_cannot_be_one_is_refused_in_pixels(plan: Path, options: dict[str, Any], said: str) -> None:
    assert refusal(plan, **options).startswith(said)


@pytest.mark.parametrize("options", [{"threshold": 1.1}, {"scale": 0}, {"scale": 1.5}, {"start": [0.5, 1]}])
def test_parameters_are_checked(plan: Path, options: dict[str, Any]) -> None:
    with pytest.raises(SettingsError, match=rf"^map\.{next(iter(options))}: expected "):
        load(plan, **options)


def test_what_is_no_image_is_named(plan: Path) -> None:
    assert refusal(plan.with_name("no.png")) == (
        "map.path: expected a readable image; got 'no.png' (No such file or directory)"
    )
    assert refusal(plan.parent).endswith("(a folder)")
    with pytest.raises(
        MapError, match=r"^map\.path: expected a readable file; got '~nobody-of-this-name/plan\.png' "
    ):
        load(Path("~nobody-of-this-name/plan.png"))
    plan.write_text("..#", encoding="utf-8")
    assert refusal(plan).startswith("map.path: expected an image that can be decoded")


def test_a_plan_of_more_cells_than_a_map_may_have_is_refused(plan: Path) -> None:
    Pillow.new("L", (4097, 4096), 255).save(plan)
    assert refusal(plan, start=[0, 0], goal=[9, 9]).endswith(
        "an image of at most 17 million cells, each of 1 x 1 pixels; got 'plan.png' (4097 x 4096)"
    )
    assert load(plan, start=[0, 0], goal=[99, 99], scale=50).shape == (82, 82)
