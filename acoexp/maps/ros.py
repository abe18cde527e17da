"""``map=ros``: a map of ROS's map_server, a YAML beside an image, planned on in metres.

:mod:`acoexp.maps.map_server` says which cells are free, occupied and unknown.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.console.plain import printable
from acoexp.errors import MapError
from acoexp.grid.frame import Frame
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.ends import check_free
from acoexp.maps.map_server import UNKNOWN, free_up_to, occupancy, parse_description
from acoexp.maps.pixels import read_pixels
from acoexp.maps.reading import read_text
from acoexp.maps.source import MapSource
from acoexp.parameters import REQUIRED, parameter


@dataclass(frozen=True, kw_only=True)
class Ros(MapSource):
    """A map of ROS's map_server: the YAML names an image, and start and goal are in metres of its frame."""

    path: str = parameter(REQUIRED, "the .yaml file, relative to the working directory")
    start: tuple[float, float] = parameter(REQUIRED, "start as [x, y] in metres of the map's frame; see map.unit")
    goal: tuple[float, float] = parameter(REQUIRED, "goal, likewise")
    unit: str = parameter(
        "metre", "of start and goal: metre; or cell, [row, column] from the top left", choices=("metre", "cell")
    )
    unknown: str = parameter("blocked", "whether unknown cells can be crossed", choices=("blocked", "free"))
    radius: float = parameter(
        0.0, "the robot's, in metres: centres that are no farther from a blocked one are blocked", minimum=0.0
    )
    moves: str = parameter("no_cut", "rule for diagonals", choices=MOVE_RULES)

    def load(self) -> Grid:
        """Read the files and return the grid, with its frame."""
        path, text = read_text(self.path, "map.path")
        name = printable(path.name)
        description = parse_description(text, name)
        pixels = read_pixels(path.parent / description.image, f"map {name}: image")
        found = occupancy(pixels, description)
        blocked = found > free_up_to(description)
        if self.unknown == "blocked":
            blocked |= found == UNKNOWN
        frame = Frame(
            rows=len(blocked), resolution=description.resolution, origin=description.origin, yaw=description.yaw
        )
        layers = _Layers(name, frame, found, blocked, inflated(blocked, self.radius / frame.resolution))
        start, goal = self._end("start", self.start, layers), self._end("goal", self.goal, layers)
        return Grid(layers.obstacles, start=start, goal=goal, moves=self.moves, name=name, frame=frame)

    def _end(self, key: str, given: tuple[float, float], layers: _Layers) -> Cell:
        """Return the cell that start or goal is in, if it is on the map and can be entered."""
        said = f"[{given[0]:.9g}, {given[1]:.9g}]"
        if self.unit == "cell" and not all(number.is_integer() for number in given):
            raise MapError(f"map.{key}: expected [row, column], whole numbers; got {said}")
        row, col = map(int, given) if self.unit == "cell" else layers.frame.to_cell(*given)
        rows, columns = layers.blocked.shape
        if not (0 <= row < rows and 0 <= col < columns):
            covered = _extent(layers.frame, columns)
            if self.unit == "cell":
                covered = f"a cell from [0, 0] to [{rows - 1}, {columns - 1}]"
            raise MapError(f"map.{key}: expected {covered}, which map {layers.name} covers; got {said}")
        if not layers.blocked[row, col]:
            reason = f"no farther than map.radius={self.radius:g} from what is blocked"
        else:
            reason = "unknown" if layers.occupancy[row, col] == UNKNOWN else "an obstacle"

        def as_given(cell: Cell) -> str:
            first, second = cell if self.unit == "cell" else layers.frame.to_metres([cell])[0].tolist()
            return f"[{first:.6g}, {second:.6g}]"

        side = (layers.frame.resolution, "m")
        check_free((row, col), layers.obstacles, f"map {layers.name}: {key} {said}", reason, as_given, side)
        return row, col


class _Layers(NamedTuple):
    """A map as it is read, layer by layer, each array [rows, cols]."""

    name: str
    frame: Frame
    occupancy: NDArray[np.int8]
    blocked: NDArray[np.bool_]
    obstacles: NDArray[np.bool_]


def _extent(frame: Frame, columns: int) -> str:
    """Say which metres a map covers."""
    corners = frame.corners(columns).tolist()
    if frame.yaw != 0.0:
        return "metres in the rectangle " + ", ".join(f"[{x:.6g}, {y:.6g}]" for x, y in corners)
    (left, bottom), _, (right, top), _ = corners
    return f"metres, x from {left:.6g} to {right:.6g} and y from {bottom:.6g} to {top:.6g}"


def inflated(blocked: NDArray[np.bool_], radius: float) -> NDArray[np.bool_]:
    """Return the cells whose centre is no farther than a radius from that of a blocked one.

    What lies outside of the map blocks nothing.

    Args:
        blocked: bool[rows, cols].
        radius: In cells.
    """
    if radius == 0.0 or not blocked.any():
        return blocked
    from scipy.ndimage import distance_transform_edt

    # 0.15 m are three cells of 0.05 m, although the quotient is a little less
    inside: NDArray[np.bool_] = distance_transform_edt(~blocked) <= radius * (1.0 + 1e-9)
    return inside
