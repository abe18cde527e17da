"""Loading a map: by name with its source's parameters, from a file, or from an array."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from acoexp.colony.diagnosis import faults_of
from acoexp.errors import SettingsError, StrategyError
from acoexp.grid.grid import Cell, Grid
from acoexp.maps.file import MapFile
from acoexp.registry.entries import entries, package_named
from acoexp.registry.parts import build_part


def load_map(name: str, /, **parameters: Any) -> Grid:
    """Return the grid of the map source that is registered under a name.

    >>> load_map("file", path="my_map.txt", start=(0, 0), moves="no_cut")

    Args:
        name: The source, as ``map=`` takes it on the command line: ``fig13``, ``file``, ``movingai`` ...
        parameters: Its parameters, those that ``python -m acoexp --help`` lists as ``map.path=`` and the like.

    Raises:
        SettingsError: if there is no such source, or for a parameter that its declaration does not allow.
        StrategyError: for a source whose package cannot be imported, or that fails or returns no grid.
        MapError: if the map cannot be read, or no path can be planned on it.
    """
    source = build_part("map", name, parameters)
    described = f"map {name!r} of package {package_named(entries('map')[name])}"
    with faults_of(source, described, "load"):
        grid = source.load()
    if not isinstance(grid, Grid):
        raise StrategyError(f"{described}: expected load to return a Grid; got {type(grid).__name__}")
    return grid


def as_grid(
    map: str | Path | Grid | ArrayLike,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
) -> Grid:
    """Return the grid that a map's name, a grid or an array stands for; see :func:`acoexp.solve`."""
    if isinstance(map, str | Grid) and (start is not None or goal is not None or moves is not None):
        raise SettingsError("start, goal and moves: expected only with a map given as an array; a map has its own")
    if isinstance(map, Grid):
        return map
    if isinstance(map, Path):
        return MapFile(path=str(map), start=start, goal=goal, moves=moves).load()
    if isinstance(map, str):
        return load_map(map)
    return Grid(map, start=start, goal=goal, moves="no_squeeze" if moves is None else moves)
