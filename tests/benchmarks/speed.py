"""How fast the colony is, beside a plain C++ program that walks the same paths, and one part beside another."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import time
import tracemalloc
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from rows import Given, Row
from timing import Timing, interleave, seconds

from acoexp.colony.problem import Problem
from acoexp.grid import Grid
from acoexp.registry.load_map import as_grid
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

ROUNDS, TRIALS, CYCLES, MAP = 15, 100, 200, "fig13"
LARGE, LARGE_TRIALS = 512, 5


def per_step(solver: Solver, trials: int) -> float:
    """Return seconds per ant step, one thread, everything that a trial costs included."""
    began = time.perf_counter()
    results = solver.solve_many(range(trials), threads=1)
    return (time.perf_counter() - began) / sum(result.ant_steps for result in results)


def large_map() -> Grid:
    """Return a 512 x 512 map, a quarter of it under rectangles that do not touch."""
    rng = np.random.default_rng(1)
    occupied = np.zeros((LARGE + 2, LARGE + 2), dtype=bool)
    while occupied.mean() < 0.25:
        height, width = rng.integers(2, 33, 2)
        row, col = rng.integers(1, LARGE - np.array([height, width]) + 2)
        if not occupied[row - 1 : row + height + 1, col - 1 : col + width + 1].any():
            occupied[row : row + height, col : col + width] = True
    return Grid(occupied[1:-1, 1:-1], name="512 x 512")


def yardstick(solver: Solver, folder: Path) -> Callable[[], float]:
    """Build the C++ program and return a job that runs it on the solver's map; the paths must be the same."""
    source, program, map_file = Path(__file__).with_name("colony.cpp"), folder / "colony", folder / "map.txt"
    subprocess.run(["g++", "-O3", "-march=native", "-o", program, source], check=True)
    write_map(solver, map_file)
    expected = walked(solver)

    def job() -> float:
        command = [program, map_file, str(TRIALS), str(CYCLES)]
        nanoseconds, steps, checksum = map(int, subprocess.check_output(command, text=True).split())
        if (steps, checksum) != expected:
            raise SystemExit("the C++ program walked other paths: nothing to compare")
        return nanoseconds / steps / 1e9

    return job


def write_map(solver: Solver, file: Path) -> None:
    problem = Problem(solver.grid, solver.settings.scalars, solver.settings.field)
    allowed = problem.per_cell(solver.grid.allowed, border=0)
    desirability = solver._ends[0].prepared.desirability.reshape(-1, 8).tolist()
    head = f"{solver.grid.shape[0]} {solver.grid.shape[1]} {problem.cell(solver.grid.start)} "
    lines = [head + str(problem.cell(solver.grid.goal))]
    lines += [f"{bits} {' '.join(map(float.hex, row))}" for bits, row in zip(allowed, desirability, strict=True)]
    file.write_text("\n".join(lines) + "\n")


def walked(solver: Solver) -> tuple[int, int]:
    """Return the ant steps and the checksum that the C++ program should print."""
    steps = checksum = 0
    for result in solver.solve_many(range(TRIALS)):
        steps += result.ant_steps
        for straight, diagonal in result.curve_pairs.tolist():
            best = (straight + diagonal) * 1000 + straight if straight >= 0 else 0
            checksum = (checksum * 31 + best) % 2**64
    return steps, checksum


def bytes_per_cell(grid: Grid, algo: str) -> float:
    """Return what a trial holds in memory while it runs, all that is made for it, per cell of the map."""
    tracemalloc.start()
    copy = Grid(grid.obstacles, name=grid.name)
    solver = Solver(copy, resolve(algo, {"iterations": 1}))
    room = solver.room_after(0)
    held, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert room.colony.stored.size
    return held / grid.obstacles.size


def rows(given: Given) -> Iterator[Row | str]:
    """Yield what a step and a trial cost, on a small map and on a large one."""
    grid, large = as_grid(MAP), large_map()
    solvers = {algo: Solver(grid, resolve(algo, {"iterations": CYCLES})) for algo in ("aco", "pd", "pdg", "pf")}
    wide = {algo: Solver(large, resolve(algo, {"iterations": CYCLES})) for algo in ("aco", "pdg")}
    steps = {algo: walked(solvers[algo])[0] / TRIALS for algo in ("aco", "pdg")}
    jobs: dict[str, Callable[[], float]] = {algo: lambda s=s: per_step(s, TRIALS) for algo, s in solvers.items()}
    jobs |= {algo_on(algo): lambda s=s: per_step(s, LARGE_TRIALS) for algo, s in wide.items()}
    many = range(10 * TRIALS)
    for n in (1, 2):
        jobs[f"{n} threads"] = lambda n=n: seconds(lambda: solvers["aco"].solve_many(many, threads=n))
    with tempfile.TemporaryDirectory() as folder:
        if shutil.which("g++") is None:
            yield "no g++ for its yardstick, a program in C++"
        else:
            jobs = {"C++": yardstick(solvers["aco"], Path(folder)), **jobs}
        timing = interleave(given.rounds or ROUNDS, jobs)
    yield from of_steps(timing, steps)
    for algo in wide:
        yield timing.row(algo_on(algo), algo, unit="ns", aim=2.0)
        memory = bytes_per_cell(large, algo)
        yield Row(name=f"{algo} on 512 x 512, memory", value=memory, unit="bytes per cell", aim=250.0)


def algo_on(algo: str) -> str:
    """Return what an algorithm on the large map is called."""
    return f"{algo} on 512 x 512, an ant step"


def of_steps(timing: Timing, steps: dict[str, float]) -> Iterator[Row]:
    """Yield the rows of the small map; ``steps`` are an algorithm's ant steps in a trial."""
    base = "C++" if "C++" in timing else ""
    if base:
        yield timing.row("C++", unit="ns", name="an ant step of the same colony in C++")
    yield timing.row("aco", base, unit="ns", name="aco, an ant step", aim=1.1 if base else None)
    yield timing.row("pd", "aco", unit="ns", name="pd (gaussian), an ant step", aim=1.6)
    yield timing.row("pf", "aco", unit="ns", name="pf (luo_wu), an ant step", aim=3.0)
    yield timing.row("pdg", "aco", unit="ns", name="pdg, an ant step")
    for algo, count in steps.items():
        timing[f"{algo}, a trial"] = [per * count for per in timing[algo]]
    yield timing.row("pdg, a trial", "aco, a trial", unit="ms", aim=4.0)
    yield timing.row("1 threads", "2 threads", unit="ms", name="1000 trials in one thread", aim=1.9, at_least=True)
