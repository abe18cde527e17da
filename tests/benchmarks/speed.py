"""How fast the colony is: a table of ratios, each measured in one run, interleaved, as the median of many rounds.

    python tests/benchmarks/speed.py [ROUNDS]

Compares with a plain C++ program that walks the same paths (it needs g++). Run it on an idle machine.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from statistics import median

import numpy as np

from acoexp.colony.problem import Problem
from acoexp.grid import Grid
from acoexp.registry.load_map import as_grid
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

TRIALS, CYCLES, MAP = 100, 200, "fig13"
LARGE, LARGE_TRIALS = 512, 5


class Timing(dict[str, list[float]]):
    """Nanoseconds by name, one value a round."""

    def ratio(self, name: str, base: str) -> float:
        return median(a / b for a, b in zip(self[name], self[base], strict=True))


def interleave(rounds: int, jobs: dict[str, Callable[[], float]]) -> Timing:
    """Run all jobs in turn, over and over, so that a drifting clock meets each alike."""
    timing = Timing({name: [] for name in jobs})
    for _ in range(rounds):
        for name, job in jobs.items():
            timing[name].append(job())
    return timing


def per_step(solver: Solver, trials: int) -> float:
    """Return ns per ant step, one thread, everything that a trial costs included."""
    began = time.perf_counter_ns()
    results = solver.solve_many(range(trials), threads=1)
    return (time.perf_counter_ns() - began) / sum(result.ant_steps for result in results)


def per_batch(solver: Solver, trials: int, threads: int) -> float:
    began = time.perf_counter_ns()
    solver.solve_many(range(trials), threads=threads)
    return float(time.perf_counter_ns() - began)


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
        return nanoseconds / steps

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


def main(rounds: int) -> None:
    grid, large = as_grid(MAP), large_map()
    solvers = {algo: Solver(grid, resolve(algo, {"iterations": CYCLES})) for algo in ("aco", "pd", "pdg", "pf")}
    wide = {algo: Solver(large, resolve(algo, {"iterations": CYCLES})) for algo in ("aco", "pdg")}
    trial_steps = {a: walked(solvers[a])[0] / TRIALS for a in ("aco", "pdg")}
    with tempfile.TemporaryDirectory() as folder:
        jobs: dict[str, Callable[[], float]] = {"c++": yardstick(solvers["aco"], Path(folder))}
        jobs |= {algo: lambda s=s: per_step(s, TRIALS) for algo, s in solvers.items()}
        jobs |= {f"large {algo}": lambda s=s: per_step(s, LARGE_TRIALS) for algo, s in wide.items()}
        jobs |= {f"{n} threads": lambda n=n: per_batch(solvers["aco"], 10 * TRIALS, n) for n in (1, 2)}
        timing = interleave(rounds, jobs)
    pdg_trial = timing.ratio("pdg", "aco") * trial_steps["pdg"] / trial_steps["aco"]
    rows = [
        ("C++, the same colony", f"{median(timing['c++']):.1f} ns", "1", ""),
        ("aco, per ant step", f"{median(timing['aco']):.1f} ns", f"{timing.ratio('aco', 'c++'):.2f} x C++", "1.1"),
        ("pd (gaussian)", f"{median(timing['pd']):.1f} ns", f"{timing.ratio('pd', 'aco'):.2f} x aco", "1.6"),
        ("pf (luo_wu)", f"{median(timing['pf']):.1f} ns", f"{timing.ratio('pf', 'aco'):.2f} x aco", "3"),
        ("pdg, per ant step", f"{median(timing['pdg']):.1f} ns", f"{timing.ratio('pdg', 'aco'):.2f} x aco", ""),
        (
            "pdg, a trial",
            f"{median(timing['pdg']) * trial_steps['pdg'] / 1e6:.2f} ms",
            f"{pdg_trial:.2f} x aco",
            "4",
        ),
        ("two threads", "", f"{timing.ratio('1 threads', '2 threads'):.2f} x one", "at least 1.9"),
    ]
    for algo in wide:
        name = f"large {algo}"
        cost = f"{median(timing[name]):.1f} ns", f"{timing.ratio(name, algo):.2f} x 20 x 20"
        rows.append((f"{algo} on 512 x 512, per ant step", *cost, "2"))
        rows.append(
            (f"{algo} on 512 x 512, memory", f"{bytes_per_cell(large, algo):.0f} bytes per cell", "", "250")
        )
    print(f"| {MAP}, {CYCLES} cycles, 10 ants | median of {rounds} | ratio | aim |\n|---|---|---|---|")
    for row in rows:
        print(f"| {' | '.join(row)} |")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 15)
