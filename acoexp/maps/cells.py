"""Cells as numbers: 0 free, 1 an obstacle, 2 the start, 3 the goal. Every format of a map's file ends in them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.errors import MapError, shown
from acoexp.grid.grid import Cell, Grid

FREE, OBSTACLE, START, GOAL = range(4)


def marked_grid(
    cells: NDArray[np.uint8],
    marks: tuple[str, str],
    *,
    name: str,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
    metadata: dict[str, Any] | None = None,
) -> Grid:
    """Return the grid of cells in which start and goal may be marked.

    Args:
        cells: uint8[rows, cols], each 0 to 3.
        marks: What marks start and goal in the file, for messages.
        name: The map's name.
        start: Start, if no cell marks it.
        goal: Goal, if no cell marks it.
        moves: Rule for diagonals; else ``no_squeeze``.
        metadata: What else the file says.

    Raises:
        MapError: if start or goal are marked twice or against the arguments, or the map is not one to plan on.
    """
    return Grid(
        cells == OBSTACLE,
        start=_marked(cells == START, marks[0], "start", start, name),
        goal=_marked(cells == GOAL, marks[1], "goal", goal, name),
        moves="no_squeeze" if moves is None else moves,
        name=name,
        metadata=metadata,
    )


def _marked(found: NDArray[np.bool_], mark: str, key: str, given: Cell | None, name: str) -> Cell | None:
    number = np.count_nonzero(found)
    if number == 0:
        return given
    if number > 1:
        raise MapError(f"map {name}: {mark} marks the {key}; expected it once, got it {number} times")
    row, col = divmod(int(found.argmax()), found.shape[1])
    if given is not None and tuple(given) != (row, col):
        raise MapError(
            f"map {name}: {mark} stands at {(row, col)}, but {key} {shown(tuple(given))} was given; drop one"
        )
    return row, col
