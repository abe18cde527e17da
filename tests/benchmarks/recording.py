"""What recording costs: off, beside an older version's worktree, and on, beside a trial that is not recorded.

python tests/benchmarks/recording.py [WORKTREE] [ROUNDS]

Nanoseconds of processor time per ant step, the best of all rounds; both sides take turns.
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).parents[2]
ALGOS = ("aco", "pd", "pdg")
SEEDS = range(60)

MEASURE = """
import sys, time
sys.path.insert(0, sys.argv[1])
import acoexp
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver
assert acoexp.__path__[0].startswith(sys.argv[1])
solver = Solver(load_map("env2"), resolve(sys.argv[2], {}))
best = float("inf")
for _ in range(12):
    before = time.process_time_ns()
    steps = sum(trial.ant_steps for trial in solver.solve_many(range(60), threads=1))
    best = min(best, (time.process_time_ns() - before) / steps)
print(best)
"""


def of_a_worktree(worktree: Path, algo: str) -> float:
    """Measure trials that are not recorded, in a process of their own."""
    command = [sys.executable, "-c", MEASURE, str(worktree.resolve()), algo]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def recorded(algo: str) -> float:
    """Measure recorded trials: the tape alone, as nothing is packed for a page."""
    from acoexp.registry.load_map import load_map
    from acoexp.registry.resolve import resolve
    from acoexp.trial.recorder import Recorder

    recorder = Recorder(load_map("env2"), resolve(algo, {}))
    best = float("inf")
    for _ in range(3):
        before, steps = time.process_time_ns(), 0
        for seed in SEEDS:
            steps += recorder.record(seed)[0].ant_steps
        best = min(best, (time.process_time_ns() - before) / steps)
    return best


def main(worktree: Path, rounds: int) -> None:
    print(f"{'ns per ant step':<18}{'older':>9}{'off':>9}{'ratio':>9}{'on':>9}{'ratio':>9}")
    for algo in ALGOS:
        pairs = [(of_a_worktree(worktree, algo), of_a_worktree(HERE, algo)) for _ in range(rounds)]
        older, off = map(min, zip(*pairs, strict=True))
        on = recorded(algo)
        print(f"{algo:<18}{older:>9.2f}{off:>9.2f}{off / older:>9.3f}{on:>9.2f}{on / off:>9.2f}", flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE, int(sys.argv[2]) if len(sys.argv) > 2 else 3)
