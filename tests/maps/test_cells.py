"""Cells as numbers: marks become ends, once and not against what is given."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp import MapError
from acoexp.maps.cells import marked_grid

YARD = np.array([[0, 2, 1], [0, 0, 0], [1, 3, 0]], dtype=np.uint8)


def test_marks_are_free_cells_and_ends() -> None:
    grid = marked_grid(YARD, ("2", "3"), name="yard", metadata={"origin": "drawn"})
    assert (grid.start, grid.goal, grid.name, grid.moves) == ((0, 1), (2, 1), "yard", "no_squeeze")
    assert grid.obstacles.tolist() == [[0, 0, 1], [0, 0, 0], [1, 0, 0]]
    assert grid.metadata == {"origin": "drawn"}


def test_what_is_not_marked_is_given_or_a_corner() -> None:
    assert marked_grid(YARD % 2, ("2", "3"), name="yard", start=(1, 1), goal=(0, 0)).start == (1, 1)
    cells = np.where(YARD == 1, 1, 0).astype(np.uint8)
    grid = marked_grid(cells, ("2", "3"), name="yard", moves="free")
    assert (grid.start, grid.goal, grid.moves) == ((0, 0), (2, 2), "free")


@pytest.mark.parametrize(
    ("cells", "start", "said"),
    [
        ([[2, 2, 0]], None, "map yard: 2 marks the start; expected it once, got it 2 times"),
        ([[2, 0, 0]], (0, 1), r"map yard: 2 stands at \(0, 0\), but start \(0, 1\) was given; drop one"),
        ([[2, 1, 3]], None, "map yard: no way leads"),
    ],
)
def test_what_is_wrong_with_marks_is_said(
    cells: list[list[int]], start: tuple[int, int] | None, said: str
) -> None:
    with pytest.raises(MapError, match=said):
        marked_grid(np.array(cells, dtype=np.uint8), ("2", "3"), name="yard", start=start)
