"""What large maps cost, before the first ant sets out and in a trial: time, and bytes a cell at the peak.

Kernels are compiled already. Before the first ant, time stands beside that of sorting a number for each cell.
Memory is all that is allocated on the way (tracemalloc), what a trial works on included. A trial is timed where
the goal is so near that ants arrive.
"""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rows import Given, Row
from timing import interleave, seconds

from acoexp.grid import Grid
from acoexp.grid.field import FieldSettings, potential_field
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

ROUNDS, SIDES = 5, (512, 1024, 2048)
ALGOS = ("aco", "pdg")
SORTING = "sorting a number a cell"
MOST_BYTES = {"grid and optimum": 100.0}
"""Bytes per cell that are aimed at, by job."""

WAREHOUSE, NEAR = (1674, 1006), 60
"""Rows and columns of the largest ROS map that was tried; columns and rows from start to goal."""

TRIALS: tuple[tuple[str, dict[str, Any]], ...] = (
    ("aco", {}),
    ("eas", {}),
    ("acs", {}),
    ("mmas", {}),
    ("aco", {"order": "lock_step"}),
    ("mmas", {"order": "lock_step"}),
)
SEEDS = range(20)


def obstacles_of(side: int) -> NDArray[np.bool_]:
    """Return a map about a quarter of which is under rectangles, with a way along its rim."""
    rng = np.random.default_rng(1)
    obstacles = np.zeros((side, side), dtype=bool)
    for _ in range(side * side // 1024):
        (row, col), (height, width) = rng.integers(0, side, 2), rng.integers(2, 33, 2)
        obstacles[row : row + height, col : col + width] = True
    obstacles[0] = obstacles[:, -1] = False
    return obstacles


def jobs_on(side: int) -> dict[str, Callable[[], object]]:
    """Return what is measured, by name."""
    obstacles, constants = obstacles_of(side), FieldSettings()
    grid = Grid(obstacles)
    numbers = np.random.default_rng(0).random(side * side)
    jobs: dict[str, Callable[[], object]] = {
        SORTING: lambda: np.sort(numbers),
        "grid and optimum": lambda: Grid(obstacles),
        "potential field": lambda: potential_field(obstacles, grid.goal, constants),
    }
    solvers = {algo: resolve(algo, {}) for algo in ALGOS}
    return jobs | {f"solver, {algo}": lambda s=s: Solver(grid, s) for algo, s in solvers.items()}


def peak(job: Callable[[], object]) -> int:
    """Return the bytes that are allocated at a time."""
    tracemalloc.start()
    job()
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return most


def near_goal() -> Grid:
    """Return a map with an obstacle on every tenth cell, start and goal in its middle."""
    obstacles = np.random.default_rng(0).random(WAREHOUSE) < 0.1
    row, col = WAREHOUSE[0] // 2, WAREHOUSE[1] // 2
    obstacles[row, col] = obstacles[row + NEAR, col + NEAR] = False
    return Grid(obstacles, start=(row, col), goal=(row + NEAR, col + NEAR), moves="no_cut")


def trial_rows(rounds: int) -> Iterator[Row]:
    """Yield a row for each trial, beside the first."""
    grid = near_goal()
    solvers = {" ".join([a, *s.values()]): Solver(grid, resolve(a, s)) for a, s in TRIALS}
    trials = {name: solver.trials(SEEDS) for name, solver in solvers.items()}
    for several in trials.values():
        next(several)  # the first fills the memory
    jobs = {name: lambda several=several: seconds(lambda: next(several)) for name, several in trials.items()}
    timing = interleave(min(rounds, len(SEEDS) - 1), jobs)
    for name in trials:
        base = "" if name == "aco" else "aco"
        yield timing.row(name, base, unit="ms", name="{}, a trial on {} x {}".format(name, *WAREHOUSE))


def rows(given: Given) -> Iterator[Row | str]:
    """Yield what is there before the first ant sets out, then trials."""
    rounds = given.rounds or ROUNDS
    for side in SIDES:
        jobs = jobs_on(side)
        most = {name: peak(job) for name, job in jobs.items()}  # compiles, too
        timing = interleave(rounds, {name: lambda job=job: seconds(job) for name, job in jobs.items()})
        for name in [*jobs][1:]:
            there = f"{name}, {side} x {side}"
            yield timing.row(name, SORTING, unit="s", name=there)
            bytes_each, aim = most[name] / side**2, MOST_BYTES.get(name)
            yield Row(name=f"{there}, memory", value=bytes_each, unit="bytes per cell", aim=aim)
    yield from trial_rows(rounds)
