"""The path of one trial for programs: ``path.csv``, and ``path.yaml`` for ROS."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from yaml.representer import SafeRepresenter

from acoexp.console.whole import whole_file
from acoexp.grid.frame import Frame
from acoexp.grid.moves import path_length
from acoexp.trial.result import Result

CSV, YAML = "path.csv", "path.yaml"
"""Files in a trial's folder; the second one only of a map that says where it lies in metres."""

_HEADER = "header: {stamp: {sec: 0, nanosec: 0}, frame_id: map}"


@dataclass(frozen=True, kw_only=True)
class Places:
    """The cells of a path as places in the plane: x to the right and y up, in metres or in cells.

    Where a map has no frame, a cell's side is 1 and (0, 0) its lower left corner, as in a frame of ROS.

    Attributes:
        unit: ``m`` or ``cell``.
        cells: int[n, 2], (row, column) from start to goal, row 0 on top.
        points: float[n, 2], (x, y) of each cell's centre.
        headings: float[n], direction to the next point in radians, counterclockwise from x, from -pi to pi; that
            of the last one is the one before it.
        lengths: float[n], length of the path up to each point.
    """

    unit: str
    cells: NDArray[np.int64]
    points: NDArray[np.float64]
    headings: NDArray[np.float64]
    lengths: NDArray[np.float64]


def write_path(result: Result, folder: Path) -> None:
    """Write the returned path of a trial, each file whole; none where no ant arrived.

    Those of an earlier trial in the folder are removed: no robot shall follow a path of another map.

    Raises:
        OSError: if one cannot be written or removed.
    """
    for name in (CSV, YAML):
        (folder / name).unlink(missing_ok=True)
    places = places_of(result)
    if places is None:
        return
    _write_lines(folder / CSV, csv_lines(places))
    if places.unit == "m":
        _write_lines(folder / YAML, _yaml_lines(places))


def places_of(result: Result) -> Places | None:
    """Return the returned path as places in the plane, or None where no ant arrived."""
    grid, moves, cells = result.grid, result.moves, result.path
    if moves is None or cells is None:
        return None
    frame = grid.frame or Frame(rows=grid.shape[0], resolution=1.0)
    is_diagonal = np.append(0, moves % 2)  # of the move that leads to a point; none leads to the first
    diagonal = np.cumsum(is_diagonal, dtype=np.float64)
    straight = np.arange(len(cells)) - diagonal
    yaw = np.arctan2(np.sin(frame.yaw), np.cos(frame.yaw))  # within a turn, as it may be of several
    headings = yaw + np.append(moves, moves[-1]) * (np.pi / 4)
    return Places(
        unit="cell" if grid.frame is None else "m",
        cells=cells,
        points=frame.to_metres(cells),
        headings=headings - 2 * np.pi * (headings > np.pi),
        lengths=path_length(straight, diagonal) * frame.resolution,
    )


def csv_lines(places: Places) -> Iterator[str]:
    """Yield the heading and a line for each place, in full precision."""
    yield f"x_{places.unit},y_{places.unit},heading_rad,length_{places.unit},row,col"
    numbers = np.column_stack([places.points, places.headings, places.lengths]).tolist()
    for place, (row, col) in zip(numbers, places.cells.tolist(), strict=True):
        yield f"{','.join(map(repr, place))},{row},{col}"


def _yaml_lines(places: Places) -> Iterator[str]:
    """Yield the fields of ``nav_msgs/Path``. PyYAML, which takes seconds, writes its numbers alone."""
    as_number = SafeRepresenter().represent_float  # 1e-17 would be a text, 1.0e-17 is a number
    yield _HEADER
    yield "poses:"
    halves = places.headings / 2
    for place in np.column_stack([places.points, np.sin(halves), np.cos(halves)]).tolist():
        x, y, z, w = (as_number(number).value for number in place)
        position, orientation = f"{{x: {x}, y: {y}, z: 0.0}}", f"{{x: 0.0, y: 0.0, z: {z}, w: {w}}}"
        yield f"- {{{_HEADER}, pose: {{position: {position}, orientation: {orientation}}}}}"


def _write_lines(file: Path, lines: Iterator[str]) -> None:
    with whole_file(file) as draft, draft.open("w", encoding="utf-8") as written:
        written.writelines(f"{line}\n" for line in lines)
