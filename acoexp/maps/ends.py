"""Start and goal on a map with a scale of its own: where they are wrong, that is said in the unit they came in."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from acoexp.errors import MapError
from acoexp.grid.grid import Cell


def check_free(
    cell: Cell,
    obstacles: NDArray[np.bool_],
    said: str,
    reason: str,
    shown_as: Callable[[Cell], str],
    side: tuple[float, str],
) -> None:
    """Refuse an end that cannot be entered, with the nearest cell that can.

    Args:
        cell: The end, inside of the map.
        obstacles: bool[rows, cols], True where no path may lead.
        said: How a message begins: the map, the key and where it is.
        reason: What is wrong with that place.
        shown_as: How a cell is written in the unit that the end was given in.
        side: A cell's side in the unit of lengths, and what that is called.

    Raises:
        MapError: if so.
    """
    if not obstacles[cell]:
        return
    rows, cols = np.nonzero(~obstacles)
    if len(rows) == 0:
        raise MapError(f"{said} is {reason}; and no cell of the map is free")
    squares = (rows - cell[0]) ** 2 + (cols - cell[1]) ** 2
    best = int(np.argmin(squares))
    length, unit = side
    raise MapError(
        f"{said} is {reason}; the nearest free cell is {length * float(squares[best]) ** 0.5:.4g} {unit} away, at "
        f"{shown_as((int(rows[best]), int(cols[best])))}"
    )
