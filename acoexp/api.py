"""``solve`` and ``solve_many``: the colony from Python, without Hydra and MLflow."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from numpy.typing import ArrayLike

from acoexp import registry
from acoexp.errors import SettingsError
from acoexp.grid import Cell, Grid
from acoexp.maps.file import MapFile
from acoexp.result import Result
from acoexp.settings import resolve
from acoexp.solver import Solver


def solve(
    map: str | Path | Grid | ArrayLike,
    algo: str = "pdg",
    seed: int = 0,
    *,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
    **settings: Any,
) -> Result:
    """Run one trial.

    Args:
        map: A registered map's name, a :class:`~acoexp.grid.Grid`, a 0/1 array [rows, cols], or the ``Path`` of a
            map file.
        algo: A preset: ``aco``, ``pd``, ``pdg``, ``pf``.
        seed: Whole number from 0 to 2^64 - 1; the same seed gives the same result.
        start: Where the ants set out, with an array or a file; by default (0, 0).
        goal: Where they want to be, with an array or a file; by default the opposite corner.
        moves: Rule for diagonals, with an array or a file; by default ``no_squeeze``.
        settings: Scalars (``alpha beta rho ants iterations q tau0``), ``field`` as a mapping, and parts
            (``heuristic choice diffusion post update``) as a name, a mapping or an object:
            ``diffusion={"name": "gaussian", "gamma": 0.02}``.

    Raises:
        SettingsError: for an unknown key or name, or a value out of range.
        MapError: for a map on which no path can be planned.
        StrategyError: for a part that cannot be loaded or compiled, or breaks its contract.
    """
    return Solver(as_grid(map, start, goal, moves), resolve(algo, settings)).solve(seed)


def solve_many(
    map: str | Path | Grid | ArrayLike,
    algo: str = "pdg",
    seeds: Iterable[int] = range(1000),
    *,
    threads: int | None = None,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
    **settings: Any,
) -> list[Result]:
    """Run one trial for each seed, on all processors; results stand in the order of the seeds.

    Args:
        map: As for :func:`solve`.
        algo: As for :func:`solve`.
        seeds: The seeds.
        threads: How many threads; by default one for each processor. Results do not depend on it.
        start: As for :func:`solve`.
        goal: As for :func:`solve`.
        moves: As for :func:`solve`.
        settings: As for :func:`solve`.

    Raises:
        SettingsError, MapError, StrategyError: As :func:`solve`.
    """
    return Solver(as_grid(map, start, goal, moves), resolve(algo, settings)).solve_many(seeds, threads)


def as_grid(
    map: str | Path | Grid | ArrayLike,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
) -> Grid:
    """Return the grid that a map's name, a grid or an array stands for; see :func:`solve`."""
    if isinstance(map, str | Grid) and (start is not None or goal is not None or moves is not None):
        raise SettingsError("start, goal and moves: expected only with a map given as an array; a map has its own")
    if isinstance(map, Grid):
        return map
    if isinstance(map, Path):
        return MapFile(path=str(map), start=start, goal=goal, moves=moves).load()
    if isinstance(map, str):
        grid: Grid = registry.build_part("map", map, {}).load()
        return grid
    return Grid(map, start=start, goal=goal, moves="no_squeeze" if moves is None else moves)
