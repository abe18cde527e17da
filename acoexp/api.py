"""``solve`` and ``solve_many``: the colony from Python, without Hydra and MLflow."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, TypedDict, Unpack

from numpy.typing import ArrayLike

from acoexp.grid.grid import Cell, Grid
from acoexp.registry.load_map import as_grid
from acoexp.registry.resolve import resolve
from acoexp.strategies.part import Choice, Diffusion, Heuristic, Post, Update
from acoexp.trial.result import Result
from acoexp.trial.solver import Solver


class Options(TypedDict, total=False):
    """Settings beside the preset's own; ``python -m acoexp --help`` has their meanings and ranges."""

    alpha: float
    beta: float
    rho: float
    ants: int
    iterations: int
    q: float
    tau0: float
    pheromone: str
    order: str
    dead_end: str
    max_steps: int | None
    field: Mapping[str, Any]
    heuristic: str | Mapping[str, Any] | Heuristic
    choice: str | Mapping[str, Any] | Choice
    diffusion: str | Mapping[str, Any] | Diffusion
    post: str | Mapping[str, Any] | Post
    update: str | Mapping[str, Any] | Update


def solve(
    map: str | Path | Grid | ArrayLike,
    algo: str = "pdg",
    seed: int = 0,
    *,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
    **settings: Unpack[Options],
) -> Result:
    """Run one trial.

    Args:
        map: A registered map's name, a :class:`~acoexp.grid.Grid` such as :func:`acoexp.load_map` returns, a 0/1
            array [rows, cols], or the ``Path`` of a map file.
        algo: A preset: ``aco``, ``pd``, ``pdg``, ``pf``, ``eas``, ``rank``, ``mmas``, ``acs``, ``nav``, or one
            that an installed package brings.
        seed: Whole number from 0 to 2^64 - 1; the same seed gives the same result.
        start: Where the ants set out, with an array or a file; by default (0, 0).
        goal: Where they want to be, with an array or a file; by default the opposite corner.
        moves: Rule for diagonals, with an array or a file; by default ``no_squeeze``.
        settings: The keys of :class:`Options`: scalars, ``field`` as a mapping, and parts as a name, a mapping of
            parameters or an object: ``diffusion={"name": "gaussian", "gamma": 0.02}``.

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
    **settings: Unpack[Options],
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
