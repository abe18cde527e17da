"""What recording costs: on, beside a trial that is not recorded; and off, beside an older version.

Processor time per ant step; each measurement has a process of its own, the best of a few.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from rows import Given, Row
from timing import interleave

HERE = Path(__file__).parents[2]
ROUNDS, ALGOS = 3, ("aco", "pd", "pdg")

MEASURE = """
import sys, time
sys.path.insert(0, sys.argv[1])
import acoexp
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
assert acoexp.__path__[0].startswith(sys.argv[1])
grid, settings = load_map("env2"), resolve(sys.argv[2], {})
if sys.argv[3] == "recorded":
    from acoexp.trial.recorder import Recorder
    recorder = Recorder(grid, settings)
    trials = lambda: (recorder.record(seed)[0] for seed in range(60))
else:
    from acoexp.trial.solver import Solver
    solver = Solver(grid, settings)
    trials = lambda: solver.solve_many(range(60), threads=1)
best = float("inf")
for _ in range(3 if sys.argv[3] == "recorded" else 12):
    before = time.process_time()
    steps = sum(trial.ant_steps for trial in trials())
    best = min(best, (time.process_time() - before) / steps)
print(best)
"""


def seconds_a_step(worktree: Path, algo: str, how: str) -> float:
    """Measure trials of a version: ``recorded``, the tape alone, as nothing is packed for a page; or ``plain``."""
    command = [sys.executable, "-c", MEASURE, str(worktree.resolve()), algo, how]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def rows(given: Given) -> Iterator[Row | str]:
    """Yield a row for each algorithm, two if there is an older version."""
    older = given.worktree
    if older is None:
        yield "recording off beside an older version: no --worktree"
    for algo in ALGOS:
        jobs = {how: lambda how=how, algo=algo: seconds_a_step(HERE, algo, how) for how in ("plain", "recorded")}
        if older is not None:
            jobs["older"] = lambda algo=algo: seconds_a_step(older, algo, "plain")
        timing = interleave(given.rounds or ROUNDS, jobs)
        yield timing.row("recorded", "plain", unit="ns", name=f"{algo}, recorded", base="not recorded")
        if older is not None:
            yield timing.row("plain", "older", unit="ns", name=f"{algo}, not recorded", base="the older version")
