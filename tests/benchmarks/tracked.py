"""What a tracked trial costs beside that of another worktree, by turns, and what the quality of its path is of it.

All is processor time, of whatever a command starts, so that a machine with other work to do may measure it.

python tests/benchmarks/tracked.py WORKTREE
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from statistics import median
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[2]
ROUNDS = 3
SEEDS = 40
COMMANDS = {
    "one trial": ["algo=pdg", "map=env2"],
    f"{SEEDS} trials of a sweep": ["algo=pdg", "map=env2", "-m", f"seed=0-{SEEDS - 1}"],
    "a batch of 1000": ["algo=pdg", "map=env2", "-m", "seeds=0-999"],
}
KEPT = f"""
import time
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.runs.trial import keep_trial
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup
import scipy.ndimage
try:
    from acoexp.command.results.artifacts import carried
    more = {{"artifacts": carried}}
except ImportError:
    more = {{}}
tracker = MlflowTracker("sqlite:///runs.db")
tracker.prepare()
setup = Setup.of(resolve("pdg", {{}}), load_map("env2"))
keep_trial(setup, 10**6, tracker, **more)
began = time.process_time()
for seed in range({SEEDS}):
    keep_trial(setup, seed, tracker, **more)
print((time.process_time() - began) / {SEEDS})
"""


def seconds(command: list[str], code: Path) -> float:
    """Return the processor time of a command in a folder of its own, by the code of a worktree."""
    with TemporaryDirectory() as folder:
        began = getrusage(RUSAGE_CHILDREN)
        where = {**os.environ, "PYTHONPATH": str(code)}
        subprocess.run(command, cwd=folder, env=where, check=True, capture_output=True)
        ended = getrusage(RUSAGE_CHILDREN)
        return ended.ru_utime + ended.ru_stime - began.ru_utime - began.ru_stime


def kept(code: Path) -> float:
    """Return what it takes to solve and keep one trial of many in one process."""
    with TemporaryDirectory() as folder:
        where = {**os.environ, "PYTHONPATH": str(code)}
        said = subprocess.run(
            [sys.executable, "-c", KEPT], cwd=folder, env=where, check=True, capture_output=True, text=True
        )
        return float(said.stdout)


def quality_seconds() -> tuple[float, float]:
    """Return how long the quality of a path takes: what is once for the map, then that of each path."""
    import scipy.ndimage  # noqa: F401

    from acoexp import load_map, solve_many

    grid = load_map("env2")
    results = solve_many(grid, "pdg", range(200))
    began = time.process_time()
    _ = grid.clearance, grid.any_angle_optimum
    once = time.process_time() - began
    began = time.process_time()
    for result in results:
        _ = result.quality
    return once, (time.process_time() - began) / len(results)


def main() -> None:
    """Print a table."""
    other = Path(sys.argv[1]).resolve()
    for code in (other, ROOT):  # so that all is compiled
        seconds([sys.executable, "-m", "acoexp", *COMMANDS["one trial"]], code)
    print("| | there | here | ratio of medians |\n|---|---|---|---|")
    rows = {name: [sys.executable, "-m", "acoexp", *arguments] for name, arguments in COMMANDS.items()}
    for name, command in rows.items():
        pairs = [(seconds(command, other), seconds(command, ROOT)) for _ in range(ROUNDS)]
        there, here = (median(times) for times in zip(*pairs, strict=True))
        print(f"| {name} | {there:.2f} s | {here:.2f} s | {here / there:.2f} |", flush=True)
    pairs = [(kept(other), kept(ROOT)) for _ in range(ROUNDS)]
    there, here = (median(times) for times in zip(*pairs, strict=True))
    print(f"| one trial more, kept | {1000 * there:.1f} ms | {1000 * here:.1f} ms | {here / there:.2f} |")
    once, each = quality_seconds()
    share = each / here
    print(f"quality: {1000 * once:.2f} ms for the map, {1000 * each:.3f} ms a path, {share:.1%} of a kept trial")


if __name__ == "__main__":
    main()
