"""``map=movingai``: maps and scenarios of the MovingAI benchmarks (Sturtevant 2012).

A map is a picture in letters: ``.`` and ``G`` ground, ``S`` swamp, entered from ground, ``W`` water, ``T`` trees,
``@`` and ``O`` out of bounds. A row of a scenario names start and goal as (x, y) = (column, row), (0, 0) on
top at the left, and the length of the shortest path that cuts no corner: ``no_cut``.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import islice
from pathlib import PurePosixPath
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.console.plain import printable
from acoexp.errors import MapError, shown
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.reading import check_size, read_text
from acoexp.maps.source import MapSource
from acoexp.parameters import REQUIRED, parameter

_FREE, _SWAMP, _BLOCKED = ".G", "S", "WT@O"
_UNKNOWN = 2


class Instance(NamedTuple):
    """A row of a scenario: which map it is for, of which size, from where to where, and its shortest length."""

    bucket: int
    map: str
    shape: tuple[int, int]
    start: Cell
    goal: Cell
    optimum: float


@dataclass(frozen=True, kw_only=True)
class MovingAI(MapSource):
    """A map of the MovingAI benchmarks, from start to goal, or as a row of a scenario says."""

    numbered = "instance"

    path: str = parameter(REQUIRED, "the .map file, relative to the working directory")
    scenario: str | None = parameter(None, "a .scen file: start and goal are those of one of its rows")
    instance: int = parameter(0, "which row of the scenario, from 0", minimum=0, maximum=10**9)
    start: Cell | None = parameter(None, "start as [row, column], 0-based, where no scenario says it")
    goal: Cell | None = parameter(None, "goal as [row, column], where no scenario says it")
    swamp: str = parameter("free", "whether swamp can be crossed", choices=("free", "blocked"))
    moves: str = parameter("no_cut", "rule for diagonals; the benchmarks' own is no_cut", choices=MOVE_RULES)

    def load(self) -> Grid:
        """Read the files and return the grid; what the scenario publishes is in its metadata."""
        path, text = read_text(self.path, "map.path")
        name = printable(path.name)
        obstacles = parse_obstacles(text, name, self.swamp)
        if self.scenario is None:
            if self.start is None or self.goal is None:
                raise MapError(f"map {name}: expected map.start and map.goal as [row, column], or map.scenario")
            return Grid(obstacles, start=self.start, goal=self.goal, moves=self.moves, name=name)
        row = self._instance(name, (obstacles.shape[0], obstacles.shape[1]))
        return Grid(
            obstacles,
            start=row.start,
            goal=row.goal,
            moves=self.moves,
            name=f"{name}#{self.instance}",
            metadata={"bucket": row.bucket, "published optimum": row.optimum},
        )

    def _instance(self, name: str, shape: tuple[int, int]) -> Instance:
        """Return the row of the scenario that is asked for, if it is one for this map."""
        if self.start is not None or self.goal is not None:
            raise MapError("map.scenario: expected no map.start and map.goal beside it, as it has its own")
        path, text = read_text(str(self.scenario), "map.scenario")
        row = parse_instance(text, self.instance, printable(path.name))
        if row.map != name or row.shape != shape:
            (rows, cols), (height, width) = shape, row.shape
            raise MapError(
                f"map.scenario: expected one for {name}, {cols} x {rows} cells; {printable(path.name)} is for "
                f"{shown(row.map)}, {shown(width)} x {shown(height)}"
            )
        return row


def parse_instance(text: str, instance: int, name: str) -> Instance:
    """Return a row of a scenario.

    Args:
        text: The scenario's file.
        instance: Which row, from 0.
        name: What the file is called in messages.

    Raises:
        MapError: if it is no scenario, has no such row, or says there what it should not.
    """
    first, *lines = text.split("\n")
    if not first.startswith("version"):
        raise MapError(f"map.scenario: expected the first line of {name} to be 'version 1'; got {shown(first)}")
    rows = [line for line in lines if line.strip()]
    if instance >= len(rows):
        raise MapError(f"map.instance: expected a row of {name}, from 0 to {len(rows) - 1}; got {instance}")
    words = next(islice(rows, instance, None)).split()
    try:
        width, height, x, y, goal_x, goal_y = map(int, words[-7:-1])
        place = PurePosixPath(" ".join(words[1:-7]).replace("\\", "/"))
        return Instance(int(words[0]), place.name, (height, width), (y, x), (goal_y, goal_x), float(words[-1]))
    except (ValueError, IndexError) as problem:
        raise MapError(
            f"map.scenario: expected nine fields in row {instance} of {name}: bucket, map, width, height, start x "
            f"and y, goal x and y, optimum; got {shown(rows[instance])}"
        ) from problem


def parse_obstacles(text: str, name: str, swamp: str) -> NDArray[np.bool_]:
    """Return which cells of a map cannot be entered, bool[rows, cols].

    Args:
        text: The map's file.
        name: What the map is called in messages.
        swamp: Whether swamp can be crossed: ``free`` or ``blocked``.

    Raises:
        MapError: if it is no map of the benchmarks, or too large.
    """
    lines = [line.rstrip("\r") for line in text.rstrip().split("\n")]
    height, width, rows = _size(lines, name)
    expected = f"map {name}: expected {height} rows of {width} cells, as its head says; got "
    if len(rows) != height:
        raise MapError(f"{expected}{len(rows)} rows")
    for number, row in enumerate(rows, 1):
        if len(row) != width:
            raise MapError(f"{expected}{len(row)} in row {number}")
    check_size(height, width, name)
    kinds = np.full(128, _UNKNOWN, dtype=np.uint8)
    for letters, kind in ((_FREE, 0), (_BLOCKED, 1), (_SWAMP, int(swamp == "blocked"))):
        kinds[[ord(letter) for letter in letters]] = kind
    signs = np.frombuffer("".join(rows).encode("ascii", "replace"), dtype=np.uint8)
    cells = kinds[signs].reshape(height, width)
    if (cells == _UNKNOWN).any():
        row, col = np.argwhere(cells == _UNKNOWN)[0].tolist()
        known = " ".join(_FREE + _SWAMP + _BLOCKED)
        raise MapError(
            f"map {name}: row {row + 1}, column {col + 1}: expected one of {known}; got {shown(rows[row][col])}"
        )
    obstacles: NDArray[np.bool_] = cells == 1
    return obstacles


def _size(lines: list[str], name: str) -> tuple[int, int, list[str]]:
    """Return the height and width that the head of a map says, and the lines after it."""
    said = dict(line.split(maxsplit=1) for line in lines[:3] if len(line.split()) == 2)
    numbers = [said.get(key, "") for key in ("height", "width")]
    if (
        said.get("type") != "octile"
        or lines[3:4] != ["map"]
        or not all(n.isascii() and n.isdigit() for n in numbers)
    ):
        raise MapError(
            f"map {name}: expected the head of a MovingAI map: 'type octile', 'height ...', 'width ...', 'map'; "
            f"got {shown(' / '.join(lines[:4]))}"
        )
    height, width = (int(number[:9]) for number in numbers)
    return height, width, lines[4:]
