"""Ends that cannot be entered: refused with the nearest cell that can."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp import MapError
from acoexp.maps.ends import check_free

YARD = np.array([[1, 1, 1, 1], [1, 1, 1, 0], [0, 1, 1, 1]], dtype=bool)


def check(cell: tuple[int, int], obstacles: np.ndarray = YARD) -> None:
    check_free(cell, obstacles, "map yard: start here", "wet", lambda at: f"<{at[0]} {at[1]}>", (0.5, "m"))


@pytest.mark.parametrize("cell", [(1, 3), (2, 0)])
def test_a_free_end_passes(cell: tuple[int, int]) -> None:
    check(cell)


@pytest.mark.parametrize(
    ("cell", "said"), [((1, 1), "0.7071 m away, at <2 0>"), ((0, 2), "0.7071 m away, at <1 3>"),
                       ((2, 1), "0.5 m away, at <2 0>")]
)  # fmt: skip
def test_another_is_refused_with_the_nearest_free_cell(cell: tuple[int, int], said: str) -> None:
    with pytest.raises(MapError) as caught:
        check(cell)
    assert str(caught.value) == f"map yard: start here is wet; the nearest free cell is {said}"


def test_where_nothing_is_free_that_is_said() -> None:
    with pytest.raises(MapError, match=r"^map yard: start here is wet; and no cell of the map is free$"):
        check((0, 0), np.ones((2, 2), bool))
