"""The frame of a map: where its cells lie in metres, by the convention of ROS."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoexp.errors import MapError, shown

_FAR = 2**31
"""Cells away at which a point is far outside of any map: a metre may be any double, a cell's number may not."""


@dataclass(frozen=True, kw_only=True)
class Frame:
    """Where the cells of a map lie: rows count from the top, y from the bottom.

    Args:
        rows: How many rows the map has.
        resolution: Side of a cell in metres, finite and above 0.
        origin: (x, y) in metres of the lower left corner of the lower left cell.
        yaw: Angle in radians by which the map is turned about that corner, counterclockwise.

    Raises:
        MapError: for a number that is none, or a resolution or number of rows that is not above 0.
    """

    rows: int
    resolution: float
    origin: tuple[float, float] = (0.0, 0.0)
    yaw: float = 0.0

    def __post_init__(self) -> None:
        x, y = self.origin
        if not (
            self.rows > 0 and self.resolution > 0 and all(map(math.isfinite, (self.resolution, x, y, self.yaw)))
        ):
            raise MapError(f"frame: expected finite numbers, rows and resolution above 0; got {shown(self)}")

    def to_metres(self, cells: ArrayLike) -> NDArray[np.float64]:
        """Return the centres of cells.

        Args:
            cells: int[n, 2] as (row, column).

        Returns:
            float[n, 2], (x, y) in metres.
        """
        row, col = np.asarray(cells).reshape(-1, 2).T
        return self._placed(col + 0.5, self.rows - row - 0.5)

    def corners(self, columns: int) -> NDArray[np.float64]:
        """Return the corners of a map in metres, float[4, 2], counterclockwise from the origin."""
        return self._placed(np.array([0, columns, columns, 0]), np.array([0, 0, self.rows, self.rows]))

    def to_cell(self, x: float, y: float) -> tuple[int, int]:
        """Return the cell (row, column) that a point in metres lies in, which may be outside of the map.

        A point on the border of two cells is in the one to the right of it, or above.
        """
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        right, up = x - self.origin[0], y - self.origin[1]
        across = (cos * right + sin * up) / self.resolution
        along = (cos * up - sin * right) / self.resolution
        col, level = (math.floor(min(max(cells, -_FAR), _FAR)) for cells in (across, along))
        return self.rows - 1 - level, col

    def _placed(self, across: NDArray[np.float64], along: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return points in metres, float[n, 2], given in cells from the origin along the map's own axes."""
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        turned = np.stack([cos * across - sin * along, sin * across + cos * along], axis=1)
        metres: NDArray[np.float64] = turned * self.resolution + self.origin
        return metres
