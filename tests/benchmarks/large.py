"""What large maps cost before the first ant sets out: seconds, and bytes a cell at the peak.

    python tests/benchmarks/large.py [ROUNDS]

Kernels are compiled already. Time is the median of the rounds, memory all that is allocated on the way
(tracemalloc), what a trial works on included. Run it on an idle machine.
"""

from __future__ import annotations

import sys
import time
import tracemalloc
from collections.abc import Callable
from statistics import median

import numpy as np
from numpy.typing import NDArray

from acoexp.grid import Grid
from acoexp.grid.field import FieldSettings, potential_field
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

SIDES = (512, 1024, 2048)
ALGOS = ("aco", "pdg")


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


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 5)
