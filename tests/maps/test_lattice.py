"""The lattice of chambers: how a side is shared out, and that the open walls are a tree and a share more."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from acoexp.maps.lattice import Walls, open_walls, spans


def parts(walls: Walls, rows: int, cols: int) -> int:
    """Return into how many parts a lattice falls, by joining what open walls join."""
    part = {(row, col): (row, col) for row in range(rows) for col in range(cols)}

    def root(cell: tuple[int, int]) -> tuple[int, int]:
        while part[cell] != cell:
            cell = part[cell]
        return cell

    for row, col in np.argwhere(walls.below).tolist():
        part[root((row, col))] = root((row + 1, col))
    for row, col in np.argwhere(walls.beside).tolist():
        part[root((row, col))] = root((row, col + 1))
    return len({root(cell) for cell in part})


@given(st.integers(1, 200), st.integers(1, 30))
def test_chambers_and_walls_share_a_side_out(cells: int, side: int) -> None:
    taken = spans(cells, side)
    assert taken.sum() == cells
    assert len(taken) % 2 == 1
    assert (taken[1::2] == 1).all()
    assert (taken[:-1:2] == side).all()
    assert taken[-1] == cells or side <= taken[-1] <= 2 * side


@given(st.integers(1, 7), st.integers(1, 7), st.integers(0, 2**32))
def test_the_open_walls_are_a_tree(rows: int, cols: int, seed: int) -> None:
    walls = open_walls(np.random.default_rng(seed), rows, cols, 0.0)
    assert (walls.below.shape, walls.beside.shape) == ((rows - 1, cols), (rows, cols - 1))
    assert walls.below.sum() + walls.beside.sum() == rows * cols - 1
    assert parts(walls, rows, cols) == 1


def test_all_walls_are_open_if_the_share_is_one() -> None:
    walls = open_walls(np.random.default_rng(0), 5, 6, 1.0)
    assert walls.below.all()
    assert walls.beside.all()


def test_a_share_of_the_others_is_open_too() -> None:
    walls = open_walls(np.random.default_rng(0), 100, 100, 0.3)
    tree, all_walls = 100 * 100 - 1, 2 * 99 * 100
    assert walls.below.sum() + walls.beside.sum() == pytest.approx(tree + 0.3 * (all_walls - tree), rel=0.03)
