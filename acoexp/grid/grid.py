"""The grid: a map on which paths are planned, checked once and then never changed."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoexp.errors import MapError, shown
from acoexp.grid.any_angle import any_angle_length
from acoexp.grid.frame import Frame
from acoexp.grid.moves import DIRECTIONS, MOVE_RULES, allowed_moves, path_length
from acoexp.grid.optimum import shortest_path

Cell = tuple[int, int]
"""A cell as (row, column), 0-based, row 0 on top; the paper's cell 1 is (0, 0)."""

_DIRECTION_OF_STEP = np.full((3, 3), 8)
for _direction, (_down, _right) in enumerate(DIRECTIONS):
    _DIRECTION_OF_STEP[_down + 1, _right + 1] = _direction


@dataclass(frozen=True, eq=False)
class Grid:
    """An occupancy grid with start, goal and a declared rule for diagonals.

    Args:
        obstacles: 0/1 or bool [rows, cols]; 1 is an obstacle. Copied, then read-only.
        start: Cell where the ants set out; the top left corner if not given.
        goal: Cell where they want to be; the corner opposite to the top left if not given.
        moves: Rule for diagonals: ``free``, ``no_squeeze``, ``no_cut`` or ``four`` (see :mod:`acoexp.grid.moves`).
        name: What the map is called in results and messages.
        metadata: Remarks that travel with the map, such as where it comes from.
        frame: Where the cells lie in metres, of a map that says it. No planner sees it, and no digest has it.

    Raises:
        MapError: if the array is empty, not two-dimensional, or holds anything but 0 and 1; if start or
            goal lie outside or on an obstacle, or are one cell; if no way leads from one to the other; if the
            frame is of another number of rows.
    """

    obstacles: NDArray[np.bool_]
    start: Cell
    goal: Cell
    moves: str
    name: str
    metadata: dict[str, Any] = field(repr=False)
    frame: Frame | None = None

    def __init__(
        self,
        obstacles: ArrayLike,
        *,
        start: Cell | None = None,
        goal: Cell | None = None,
        moves: str = "no_squeeze",
        name: str = "array",
        metadata: dict[str, Any] | None = None,
        frame: Frame | None = None,
    ) -> None:
        try:
            occupied = _as_occupancy(obstacles, name)
            rows, cols = occupied.shape
            values = {
                "obstacles": occupied,
                "start": _as_cell(start if start is not None else (0, 0), "start", name),
                "goal": _as_cell(goal if goal is not None else (rows - 1, cols - 1), "goal", name),
                "moves": moves,
                "name": name,
                "metadata": dict(metadata or {}),
                "frame": frame,
            }
            for key, value in values.items():
                object.__setattr__(self, key, value)
            self._check()
        except MemoryError as problem:
            came = f"{name}: expected a map for which the memory suffices; got shape {np.shape(obstacles)}"
            raise MapError(f"map {came}") from problem

    def _check(self) -> None:
        if self.moves not in MOVE_RULES:
            rules = ", ".join(MOVE_RULES)
            raise MapError(f"map {self.name}: moves: expected one of: {rules}; got {shown(self.moves)}")
        rows, cols = self.shape
        if self.frame is not None and self.frame.rows != rows:
            raise MapError(f"map {self.name}: frame: expected one of {rows} rows; got one of {self.frame.rows}")
        for key, (row, col) in (("start", self.start), ("goal", self.goal)):
            if not (0 <= row < rows and 0 <= col < cols):
                raise MapError(
                    f"map {self.name}: {key} {shown((row, col))} lies outside; expected a cell from (0, 0) to "
                    f"({rows - 1}, {cols - 1})"
                )
            if self.obstacles[row, col]:
                raise MapError(f"map {self.name}: {key} ({row}, {col}) is an obstacle; expected a free cell")
        if self.start == self.goal:
            raise MapError(f"map {self.name}: start and goal are one cell, {self.start}; expected two")
        if self.shortest_path is None:
            raise MapError(
                f"map {self.name}: no way leads from start {self.start} to goal {self.goal} under the rule "
                f"{self.moves!r}; expected a map with at least one"
            )

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take what was pickled over; NumPy forgets that an array was read-only."""
        self.__dict__.update(state)
        for value in state.values():
            if isinstance(value, np.ndarray):
                value.flags.writeable = False

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, cols = self.obstacles.shape
        return rows, cols

    @cached_property
    def allowed(self) -> NDArray[np.uint8]:
        """The neighbour table, uint8[rows, cols]: bit d is set where the move in direction d is allowed."""
        table = allowed_moves(self.obstacles, self.moves)
        table.flags.writeable = False
        return table

    @cached_property
    def shortest_path(self) -> NDArray[np.int64]:
        """One exact shortest path, int[n, 2] (None only while the constructor checks that there is one)."""
        return shortest_path(self.allowed, self.start, self.goal)  # type: ignore[return-value]

    @cached_property
    def optimum_pair(self) -> tuple[int, int]:
        """The exact optimum as (straight, diagonal) moves."""
        return self.measure(self.shortest_path)

    @property
    def optimum(self) -> float:
        """The exact optimum's length, in cells."""
        return path_length(*self.optimum_pair)

    @cached_property
    def any_angle_optimum(self) -> float:
        """Length of a shortest path whose segments may have any angle, in cells; nan where the search is given up.

        It is the exact lower bound of any path's length on this map, see :mod:`acoexp.grid.any_angle`.
        """
        length = any_angle_length(self.obstacles, self.start, self.goal, squeezes=self.moves == "free")
        return min(length, self.optimum)  # where they are the same, also when rounded; nan stays

    @cached_property
    def clearance(self) -> NDArray[np.float64]:
        """Distance from each cell's centre to that of the nearest obstacle, float64[rows, cols], in cells.

        It is 0 on obstacles, and nan everywhere on a map that has none: what is around a map is no obstacle. By
        the exact Euclidean distance transform (Maurer, Qi and Raghavan 2003).
        """
        from scipy.ndimage import distance_transform_edt

        free = ~self.obstacles
        table = np.full(self.shape, np.nan) if free.all() else distance_transform_edt(free)
        table.flags.writeable = False
        return table

    @cached_property
    def digest(self) -> str:
        """A short fingerprint of everything that a planner sees: shape, obstacles, start, goal, rule."""
        content = f"{self.shape} {self.start} {self.goal} {self.moves} ".encode()
        return hashlib.sha256(content + np.packbits(self.obstacles).tobytes()).hexdigest()[:16]

    def measure(self, path: ArrayLike) -> tuple[int, int]:
        """Check a path move by move and return its (straight, diagonal) moves.

        Args:
            path: Cells int[n, 2] as (row, column).

        Raises:
            MapError: if it does not lead from start to goal, or one of its moves is not allowed.
        """
        try:
            cells = np.asarray(path)
        except ValueError as problem:
            raise MapError(f"map {self.name}: expected a path int[n, 2]; got a ragged one") from problem
        if cells.ndim != 2 or cells.shape[1] != 2 or len(cells) < 2 or cells.dtype.kind not in "iu":
            raise MapError(
                f"map {self.name}: expected a path int[n, 2], n >= 2; got {cells.dtype} of shape {cells.shape}"
            )
        cells = cells.astype(np.int64)
        ends = (tuple(cells[0].tolist()), tuple(cells[-1].tolist()))
        if ends != (self.start, self.goal):
            raise MapError(
                f"map {self.name}: expected a path from {self.start} to {self.goal}; got one from "
                f"{ends[0]} to {ends[1]}"
            )
        steps = np.diff(cells, axis=0)
        near = (np.abs(steps) <= 1).all(axis=1)
        direction = _DIRECTION_OF_STEP[tuple((np.clip(steps, -1, 1) + 1).T)]
        inside = ((cells >= 0) & (cells < self.shape)).all()
        source = np.clip(cells[:-1], 0, np.subtract(self.shape, 1))
        allowed = near & (direction < 8) & (self.allowed[tuple(source.T)] >> direction & 1).astype(bool)
        if not (inside and allowed.all()):
            at = int(np.argmin(allowed))
            raise MapError(
                f"map {self.name}: move {at + 1} of a path, from {tuple(cells[at].tolist())} to "
                f"{tuple(cells[at + 1].tolist())}, is not allowed under the rule {self.moves!r}"
            )
        diagonal = int((direction % 2).sum())
        return len(steps) - diagonal, diagonal


def _as_occupancy(obstacles: ArrayLike, name: str) -> NDArray[np.bool_]:
    try:
        array = np.asarray(obstacles)
    except ValueError as problem:
        raise MapError(f"map {name}: expected rows of one length; got a ragged array") from problem
    if np.ma.is_masked(obstacles):
        raise MapError(f"map {name}: expected an array of 0 and 1; got one of which a part is masked")
    if array.ndim != 2 or array.size == 0:
        raise MapError(f"map {name}: expected an array [rows, cols] of 0 and 1; got shape {array.shape}")
    occupied = array.astype(bool) if array.dtype.kind in "biuf" else None
    if occupied is None or not np.array_equal(occupied, array):
        raise MapError(f"map {name}: expected only 0 (free) and 1 (obstacle); got other values")
    occupied.flags.writeable = False
    return occupied


def _as_cell(cell: Any, key: str, name: str) -> Cell:
    try:
        row, col = cell
        if isinstance(row, bool) or isinstance(col, bool):
            raise TypeError
        return int(row.__index__()), int(col.__index__())
    except (TypeError, ValueError, AttributeError):
        raise MapError(f"map {name}: {key}: expected (row, column), whole numbers; got {shown(cell)}") from None
