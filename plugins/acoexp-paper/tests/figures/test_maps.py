"""Maps with forces and with paths."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest
from acoexp_paper.figures.maps import draw_fields, draw_path, length_of
from matplotlib.colors import to_hex

from acoexp.grid.field import FieldSettings, potential_field
from acoexp.grid.grid import Grid
from acoexp.registry.load_map import load_map
from acoexp.report.palette import BLUE, ORANGE


@dataclass
class Walked:
    """What a figure asks of a result."""

    grid: Grid
    raw_path: np.ndarray | None
    path: np.ndarray | None
    length: float


def test_a_path_is_measured_by_its_moves() -> None:
    assert length_of(np.array([(0, 0), (1, 1), (1, 2), (2, 1)])) == 1 + 2 * math.sqrt(2)


def test_the_path_is_drawn_as_it_was_walked_and_optimised() -> None:
    walked, optimised = np.array([(0, 0), (0, 1), (1, 1), (1, 2)]), np.array([(0, 0), (0, 1), (1, 2)])
    grid = Grid(np.zeros((2, 3)))
    (axes,) = draw_path("one ant", Walked(grid, walked, optimised, 1 + math.sqrt(2))).axes
    lines = {line.get_label(): np.transpose(line.get_data()).tolist() for line in axes.lines}
    assert lines["as walked, 3.0000 cells"] == [[col, row] for row, col in walked]
    assert lines["optimised, 2.4142 cells"] == [[col, row] for row, col in optimised]


@pytest.mark.parametrize("moves", ["free", "no_cut"])
def test_forces_along_forbidden_moves_are_orange(moves: str) -> None:
    grid = Grid(load_map("fig13").obstacles, moves=moves)
    axes = draw_fields({"fig13": grid, "env2": grid}, FieldSettings()).axes[0]
    (blue, orange) = axes.collections[1:]
    field = potential_field(grid.obstacles, grid.goal, FieldSettings())
    pulled = ~grid.obstacles & (field.sector < 8)
    forbidden = sum(
        (grid.allowed[cell] >> field.sector[cell] & 1) == 0 for cell in zip(*pulled.nonzero(), strict=True)
    )
    assert (len(blue.get_offsets()), len(orange.get_offsets())) == (pulled.sum() - forbidden, forbidden)
    assert [to_hex(quiver.get_facecolor()[0]) for quiver in (blue, orange)] == [BLUE.lower(), ORANGE.lower()]
    assert forbidden > 0
