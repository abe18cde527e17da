"""The pictures of a trial: what is drawn on them, and that any trial on any map can be drawn."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from acoexp import Grid, Result
from acoexp.command.results import pictures
from acoexp.command.results.pictures import draw_convergence, draw_map
from acoexp.grid.frame import Frame

E, NE, N, NW, W, SW, S, SE = range(8)

YARD = Grid(np.zeros((3, 4)), name="yard")
BEST, WALKED = [SE, SE, E], [E, E, SE, SE]


def result(moves: list[int] | None = BEST, raw_moves: list[int] | None = None, **changes: Any) -> Result:
    """Return a trial, with a convergence curve that loses all ants once."""
    made: dict[str, Any] = {
        "algo": "pdg", "seed": 3, "grid": YARD, "cycle_steps": np.ones(4, dtype=np.int64),
        "moves": None if moves is None else np.array(moves, dtype=np.uint8),
        "raw_moves": None if raw_moves is None else np.array(raw_moves, dtype=np.uint8),
        "curve_pairs": np.array([[5, 0], [-1, -1], [1, 2], [3, 1]], dtype=np.int32),
        "lost_ants": np.zeros(4, dtype=np.int32),
    }  # fmt: skip
    return Result(**made | changes)


LOST = result(moves=None, curve_pairs=np.full((4, 2), -1, dtype=np.int32))


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the figures that would be saved."""
    figures: list[Figure] = []
    monkeypatch.setattr(pictures, "_save", lambda figure, file: figures.append(figure))
    return figures


def axes_of(figures: list[Figure]) -> Axes:
    """Return what is drawn in the only figure."""
    (figure,) = figures
    return figure.axes[0]


def lines(axes: Axes) -> dict[str, list[tuple[float, float]]]:
    """Return the points of each line by its label."""
    return {str(line.get_label()): [(x, y) for x, y in line.get_xydata()] for line in axes.lines}


def test_the_map_shows_the_path_from_start_to_goal(drawn: list[Figure]) -> None:
    draw_map(result(), Path("unused"))
    shown = lines(axes_of(drawn))
    assert shown == {
        "path, 3.8284": [(0, 0), (1, 1), (2, 2), (3, 2)], "start": [(0, 0)], "goal": [(3, 2)],
    }  # fmt: skip
    assert axes_of(drawn).get_title() == "pdg on yard, seed 3 (optimum 3.8284)"


@pytest.mark.parametrize(("raw_moves", "is_shown"), [(WALKED, True), (BEST, False), (None, False)])
def test_the_path_as_walked_is_shown_where_it_differs(
    drawn: list[Figure], raw_moves: list[int] | None, is_shown: bool
) -> None:
    draw_map(result(raw_moves=raw_moves), Path("unused"))
    assert ("as walked" in lines(axes_of(drawn))) == is_shown


def test_obstacles_are_drawn_where_they_are(drawn: list[Figure]) -> None:
    grid = Grid([[0, 1, 0], [0, 0, 0]])
    draw_map(result(grid=grid, moves=[SE, E]), Path("unused"))
    (image,) = axes_of(drawn).images
    assert np.array_equal(np.asarray(image.get_array()), grid.obstacles)


def test_where_no_ant_arrived_the_map_has_no_path(drawn: list[Figure]) -> None:
    draw_map(LOST, Path("unused"))
    assert lines(axes_of(drawn)).keys() == {"start", "goal"}


def test_a_map_with_a_frame_is_drawn_in_metres(drawn: list[Figure]) -> None:
    frame = Frame(rows=3, resolution=0.5, origin=(-1.0, 2.0))
    draw_map(result(grid=Grid(np.zeros((3, 4)), name="yard", frame=frame)), Path("unused"))
    axes = axes_of(drawn)
    path = [(-0.75, 3.25), (-0.25, 2.75), (0.25, 2.25), (0.75, 2.25)]
    assert lines(axes) == {"path, 1.9142 m": path, "start": path[:1], "goal": path[-1:]}
    assert axes.get_title() == "pdg on yard, seed 3 (optimum 1.9142 m)"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (m)", "y (m)")
    assert (axes.get_xlim(), axes.get_ylim()) == ((-1.0, 1.0), (2.0, 3.5))


@pytest.mark.parametrize("frame", [None, Frame(rows=3, resolution=0.5, origin=(-1.0, 2.0), yaw=1.0)])
def test_obstacles_lie_under_their_cells_however_a_map_is_turned(drawn: list[Figure], frame: Frame | None) -> None:
    grid = Grid([[0, 1, 0], [0, 0, 0], [0, 0, 0]], frame=frame)
    draw_map(result(grid=grid, moves=[S, S, E, E]), Path("unused"))
    axes = axes_of(drawn)
    (figure,) = drawn
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    seen = np.asarray(canvas.buffer_rgba())[::-1, :, 0]  # pixels are counted from below
    centres = [(row, col) for row in range(3) for col in (1, 2) if row < 2]  # those that no path runs through
    places = [(col, row) for row, col in centres] if frame is None else frame.to_metres(centres)
    shades = [int(seen[int(y), int(x)]) for x, y in axes.transData.transform(places)]
    assert [shade < 128 for shade in shades] == [grid.obstacles[cell] for cell in centres]


@pytest.mark.parametrize(("cols", "limits"), [(64, (-0.5, 63.5)), (400, (160.5, 260.5))])
def test_of_a_large_map_what_lies_about_the_path_is_drawn(
    drawn: list[Figure], cols: int, limits: tuple[float, float]
) -> None:
    grid = Grid(np.zeros((9, cols)), start=(4, cols // 2 - 6), goal=(4, cols // 2 + 27))
    draw_map(result(grid=grid, moves=[E] * 33), Path("unused"))
    assert axes_of(drawn).get_xlim() == limits
    assert axes_of(drawn).get_ylim() == (8.5, -0.5)


def test_what_lies_about_the_free_cells_of_a_large_map_is_not_drawn(drawn: list[Figure]) -> None:
    obstacles = np.ones((200, 300), dtype=bool)
    obstacles[50:60, 100:190] = False
    draw_map(result(grid=Grid(obstacles, start=(50, 100), goal=(50, 189)), moves=[E] * 89), Path("unused"))
    axes = axes_of(drawn)
    assert (axes.get_xlim(), axes.get_ylim()) == ((97.5, 191.5), (61.5, 47.5))
    (image,) = axes.images
    assert np.array_equal(np.asarray(image.get_array()), obstacles[48:62, 98:192])


def test_the_curve_shows_its_features_and_the_optimum(drawn: list[Figure]) -> None:
    draw_convergence(result(), Path("unused"))
    shown = lines(axes_of(drawn))
    assert shown.keys() == {"optimum, 3.8284", "best in the cycle", "x1 = 3, 3.8284", "x3 = 4, 4.4142"}
    assert [x for x, _ in shown["best in the cycle"]] == [1, 2, 3, 4]
    assert shown["x1 = 3, 3.8284"] == [(3.0, YARD.optimum)]


def test_features_that_there_are_not_are_not_drawn(drawn: list[Figure]) -> None:
    draw_convergence(LOST, Path("unused"))
    assert lines(axes_of(drawn)).keys() == {"optimum, 3.8284", "best in the cycle"}


@pytest.mark.parametrize("shape", [(1, 300), (300, 1), (2, 2), (16_384, 1), (2048, 2048)])
def test_a_map_of_any_shape_makes_a_picture_that_a_screen_can_show(shape: tuple[int, int], tmp_path: Path) -> None:
    draw_map(result(grid=Grid(np.zeros(shape)), moves=None), tmp_path / "path.png")
    with Image.open(tmp_path / "path.png") as picture:
        assert picture.format == "PNG"
        assert 200 < min(picture.size) <= max(picture.size) < 2000
