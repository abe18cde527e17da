"""What a tracked trial costs beside that of another worktree, by turns, and what the quality of its path is of it.

All is processor time, of whatever a command starts, so that a machine with other work to do may measure it.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from rows import Given, Row
from timing import Timing, interleave, processor_seconds

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


def command_seconds(arguments: list[str], code: Path) -> float:
    """Return the processor time of a command in a folder of its own, by the code of a worktree."""
    with TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "acoexp", *arguments]
        return processor_seconds(command, folder, {**os.environ, "PYTHONPATH": str(code)})


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


def by_turns(rounds: int, job: Callable[[Path], float], name: str, other: Path) -> Timing:
    """Return what a job takes here and by the code of the other worktree."""
    return interleave(rounds, {"the other version": lambda: job(other), name: lambda: job(ROOT)})


def rows(given: Given) -> Iterator[Row | str]:
    """Yield a row for each command, for one trial more, and for its path's quality."""
    if given.worktree is None:
        yield "no --worktree to compare with"
        return
    other, rounds = given.worktree.resolve(), given.rounds or ROUNDS
    for code in (other, ROOT):  # so that all is compiled
        command_seconds(COMMANDS["one trial"], code)
    for name, arguments in COMMANDS.items():
        timing = by_turns(rounds, lambda code, a=arguments: command_seconds(a, code), name, other)
        yield timing.row(name, "the other version", unit="s")
    timing = by_turns(rounds, kept, "one trial more, kept", other)
    yield (more := timing.row("one trial more, kept", "the other version", unit="ms"))
    once, each = quality_seconds()
    yield Row(name="quality, once for a map", value=1e3 * once, unit="ms")
    share = 1e3 * each / more.value
    yield Row(name="quality of a path", value=1e3 * each, unit="ms", ratio=share, base="one trial more, kept")
