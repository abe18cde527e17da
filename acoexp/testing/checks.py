"""What the contract's tests look at: maps, paths, pheromone that is laid astray, and what a step costs."""

from __future__ import annotations

import hashlib
import json
import time
from collections.abc import Iterable
from statistics import median
from typing import Any

import numpy as np

from acoexp.grid.grid import Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.strategies.part import STRATEGIES
from acoexp.trial.result import Result
from acoexp.trial.solver import Solver

PLAIN = {
    "heuristic": "goal_distance",
    "choice": "roulette",
    "diffusion": "none",
    "post": "none",
    "update": "ant_cycle",
}
"""The part of each group that a part's cost is measured against."""

SEEDS = range(3)
FEW: dict[str, Any] = {"ants": 4, "iterations": 10}
ROUNDS, TRIALS = 7, 20


def maps() -> list[Grid]:
    """Return an open map, and one with obstacles at random under each rule for diagonals."""
    grids = [Grid(np.zeros((7, 9)), name="open")]
    draw = np.random.default_rng(0)
    for rule in MOVE_RULES:
        obstacles = draw.random((12, 15)) < 0.2
        obstacles[0, :] = obstacles[:, -1] = False  # so there is a way
        grids.append(Grid(obstacles, moves=rule, name=f"random, {rule}"))
    return grids


def solvers(part: Any, algo: str, settings: dict[str, Any]) -> Iterable[tuple[Grid, Solver]]:
    """Yield each map with a solver that has the part."""
    resolved = resolve(algo, {**FEW, **settings, group_of(part): part})
    for grid in maps():
        yield grid, Solver(grid, resolved)


def group_of(part: Any) -> str:
    """Return the group that a part belongs to."""
    return next(group for group, kind in STRATEGIES.items() if isinstance(part, kind))


def check_paths(grid: Grid, result: Result) -> bool:
    """Check the paths of a trial move by move; return whether there is one."""
    if result.path is None:
        return False
    assert grid.measure(result.path) == result.l1_pair, f"on {grid.name}: a path and its length differ"
    assert result.length >= grid.optimum, f"on {grid.name}: a path of {result.length}, optimum {grid.optimum}"
    if result.raw_path is not None:
        grid.measure(result.raw_path)
    return True


def laid_astray(solver: Solver, seed: int) -> list[str]:
    """Return the moves that are not allowed whose pheromone a trial changed, as texts.

    Known by that they are unlike the others that began alike; evaporation and limits are the same for all.
    """
    room = solver.room_after(seed)
    colony = room.colony
    allowed = np.unpackbits(colony.allowed[:, None], axis=1, bitorder="little").ravel()
    closed = np.flatnonzero(allowed == 0)
    began = np.broadcast_to(room.initial, colony.stored.shape)[closed]
    astray: list[str] = []
    for level in np.unique(began):
        edges = closed[began == level]
        levels, counts = np.unique(colony.stored[edges], return_counts=True)
        for edge in edges[colony.stored[edges] != levels[counts.argmax()]]:
            row, col = divmod(int(edge) // 8, int(colony.width))
            astray.append(f"direction {edge % 8} from ({row - 1}, {col - 1})")
    return astray


def gone_twice(solver: Solver, seed: int) -> tuple[int, int] | None:
    """Return a cell, (row, column), to which an ant of a trial's last cycle went twice; None if there is none."""
    room = solver.room_after(seed)
    for ant in range(room.colony.ants):
        moves = room.raw.moves[ant, : room.raw.steps[ant]]
        cells = int(room.colony.start) + np.cumsum(np.append(0, room.colony.offsets[moves]))
        known, counts = np.unique(cells, return_counts=True)
        if counts.max() > 1:
            row, col = divmod(int(known[counts.argmax()]), int(room.colony.width))
            return row - 1, col - 1
    return None


def everything(result: Result) -> str:
    """Return all that a trial leaves behind, as one text to be compared."""
    return json.dumps(result.as_dict())


def digest(part: Any, algo: str, settings: dict[str, Any]) -> str:
    """Return a digest of all that the part's trials leave behind."""
    found = [everything(solver.solve(seed)) for _, solver in solvers(part, algo, settings) for seed in SEEDS]
    return hashlib.sha256("\n".join(found).encode()).hexdigest()


def cost(algo: str, settings: dict[str, Any], group: str) -> tuple[float, float, float]:
    """Return ns per ant step with a part, with its group's plain one, and the ratio: medians, interleaved."""
    chosen: tuple[dict[str, Any], ...] = settings, {**settings, group: PLAIN[group]}
    ready = [Solver(load_map("env2"), resolve(algo, each)) for each in chosen]
    times = [[ns_per_step(solver) for solver in ready] for _ in range(ROUNDS)]
    own, plain = (median(column) for column in zip(*times, strict=True))
    return own, plain, median(a / b for a, b in times)


def ns_per_step(solver: Solver) -> float:
    """Return ns per ant step, everything that a trial costs included."""
    began = time.perf_counter_ns()
    results = solver.solve_many(range(TRIALS), threads=1)
    return (time.perf_counter_ns() - began) / sum(result.ant_steps for result in results)
