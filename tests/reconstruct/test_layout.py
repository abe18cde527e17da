"""Layouts: rectangles on a map, and what becomes of them."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp.reconstruct.layout import FEWEST, MOST, is_layout, is_map, mutate, paint, random_layout


def test_a_rectangle_covers_its_cells_and_no_others() -> None:
    obstacles = paint(np.array([[2, 3, 4, 8], [3, 7, 6, 9]]))
    assert {(int(r), int(c)) for r, c in np.argwhere(obstacles)} == {
        *((r, c) for r in (2, 3) for c in range(3, 8)),
        *((r, c) for r in (3, 4, 5) for c in (7, 8)),
    }


@pytest.mark.parametrize(
    ("rectangle", "fine"),
    [
        ([0, 0, 1, 2], True),
        ([8, 3, 20, 15], True),
        ([0, 0, 1, 1], False),  # a single cell is noise
        ([0, 0, 13, 1], False),  # too long
        ([5, 5, 5, 9], False),  # empty
        ([5, 9, 8, 5], False),  # inside out
        ([-1, 0, 2, 2], False),
        ([17, 4, 21, 8], False),
    ],
)
def test_a_rectangle_lies_on_the_map_and_has_two_cells_at_least(rectangle: list[int], fine: bool) -> None:
    assert is_layout(np.array([[1, 1, 3, 3], rectangle])) == fine


def test_start_and_goal_are_free_and_a_map_is_neither_empty_nor_crammed() -> None:
    blocks = np.array([[2, 2, 12, 12]])
    assert is_map(paint(blocks))
    assert not is_map(paint(np.vstack([blocks, [0, 0, 2, 2]])))
    assert not is_map(paint(np.vstack([blocks, [18, 18, 20, 20]])))
    assert not is_map(paint(blocks[:, :] * [1, 1, 0, 1] + [0, 0, 4, 0]))
    assert not is_map(paint(np.vstack([blocks, [12, 2, 19, 14]])))


def test_a_neighbour_is_near_and_leaves_what_it_came_from_alone() -> None:
    rng = np.random.default_rng(0)
    layout = random_layout(rng)
    before = layout.copy()
    for _ in range(200):
        neighbour = mutate(layout, rng)
        kept = {tuple(r) for r in layout.tolist()} & {tuple(r) for r in neighbour.tolist()}
        assert len(kept) >= len(layout) - 3
        assert FEWEST <= len(neighbour) <= MOST
    assert (layout == before).all()
