"""What all figures share."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from acoexp_paper.figures.drawing import draw_grid, new_figure, save
from PIL import Image

from acoexp.grid.grid import Grid

YARD = Grid([[0, 0, 1], [0, 0, 0]])


def test_a_figure_is_saved_twice_as_the_same_bytes(tmp_path: Path) -> None:
    def saved(name: str) -> tuple[str, bytes, bytes]:
        (folder := tmp_path / name).mkdir()
        figure = new_figure(2.0)
        figure.subplots().plot([0, 1], [1, 0], "o--", label="a line")
        svg = save(figure, folder, "fig01")
        return svg, (folder / "fig01.svg").read_bytes(), (folder / "fig01.png").read_bytes()

    svg, svg_bytes, png_bytes = saved("first")
    assert svg.encode() == svg_bytes
    assert saved("second") == (svg, svg_bytes, png_bytes)


def test_a_figure_is_as_large_as_it_is_asked_to_be(tmp_path: Path) -> None:
    save(new_figure(2.0, width=3.0), tmp_path, "fig01")
    with Image.open(tmp_path / "fig01.png") as picture:
        assert picture.size == (600, 400)


def test_a_map_has_row_0_on_top_and_its_obstacles_filled() -> None:
    axes = new_figure(2.0).subplots()
    draw_grid(axes, YARD)
    assert axes.get_xlim() == (-0.5, 2.5)
    assert axes.get_ylim() == (1.5, -0.5)
    (mesh,) = axes.collections
    np.testing.assert_array_equal(~np.ma.getmaskarray(mesh.get_array()).reshape(2, 3), YARD.obstacles)


def test_a_dot_is_the_start_and_a_star_the_goal() -> None:
    axes = new_figure(2.0).subplots()
    draw_grid(axes, YARD)
    drawn = {line.get_marker(): (*line.get_xdata(), *line.get_ydata()) for line in axes.lines}
    assert drawn == {"o": (0, 0), "*": (2, 1)}
