"""What large maps cost, before the first ant sets out and in a trial: seconds, and bytes a cell at the peak.

    python tests/benchmarks/large.py [ROUNDS]

Kernels are compiled already. Time is the median of the rounds, memory all that is allocated on the way
(tracemalloc), what a trial works on included. A trial is timed where the goal is so near that ants arrive. Run it
on an idle machine.
"""

from __future__ import annotations

import sys
import time
import tracemalloc
from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.grid import Grid
from acoexp.grid.field import FieldSettings, potential_field
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

SIDES = (512, 1024, 2048)
ALGOS = ("aco", "pdg")

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
    jobs: dict[str, Callable[[], object]] = {
        "grid and optimum": lambda: Grid(obstacles),
        "potential field": lambda: potential_field(obstacles, grid.goal, constants),
    }
    solvers = {algo: resolve(algo, {}) for algo in ALGOS}
    return jobs | {f"solver, {algo}": lambda s=s: Solver(grid, s) for algo, s in solvers.items()}


def seconds(job: Callable[[], object]) -> float:
    began = time.perf_counter()
    job()
    return time.perf_counter() - began


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


def trial_table(rounds: int) -> list[tuple[str, float, float]]:
    """Return a trial's name, its seconds, and these as a multiple of the first's."""
    grid = near_goal()
    solvers = {" ".join([a, *s.values()]): Solver(grid, resolve(a, s)) for a, s in TRIALS}
    trials = {name: solver.trials(SEEDS) for name, solver in solvers.items()}
    spent: dict[str, list[float]] = {name: [] for name in trials}
    for _ in range(rounds + 1):
        for name, results in trials.items():
            spent[name].append(seconds(lambda results=results: next(results)))
    times = {name: median(several[1:]) for name, several in spent.items()}  # the first fills the memory
    return [(name, time, time / times["aco"]) for name, time in times.items()]


def main(rounds: int) -> None:
    """Print the table."""
    jobs = {side: jobs_on(side) for side in SIDES}
    most = {(side, name): peak(job) for side in SIDES for name, job in jobs[side].items()}  # compiles, too
    spent: dict[tuple[int, str], list[float]] = {key: [] for key in most}
    for _ in range(rounds):
        for side, name in most:
            spent[side, name].append(seconds(jobs[side][name]))
    print(f"| median of {rounds} | {' | '.join(f'{side} x {side}' for side in SIDES)} |")
    print(f"|---{'|---' * len(SIDES)}|")
    for name in jobs[SIDES[0]]:
        cells = (f"{median(spent[s, name]):.2f} s, {most[s, name] / s**2:.0f} bytes per cell" for s in SIDES)
        print(f"| {name} | {' | '.join(cells)} |")
    print("\n| a trial on {} x {} | median | x aco |\n|---|---|---|".format(*WAREHOUSE))
    for name, time_of_it, ratio in trial_table(min(rounds, len(SEEDS) - 1)):
        print(f"| {name} | {1e3 * time_of_it:.1f} ms | {ratio:.1f} |")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
