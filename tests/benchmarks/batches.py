"""Twelve thousand trials as twelve batches, tracked: time beside that of solving alone, and the peak of memory."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import psutil
from rows import Given, Row
from timing import interleave, seconds

from acoexp import solve_many

ROUNDS, SEEDS = 3, 1000
ALGOS, MAPS = ("aco", "pd", "pdg", "pf"), ("fig13", "env1", "env2")
SWEEP = [f"algo={','.join(ALGOS)}", f"map={','.join(MAPS)}", "-m"]


def rows(given: Given) -> Iterator[Row | str]:
    """Yield the time of the command and the most memory that it held."""
    name, alone, peaks = f"12 batches of {SEEDS}", "solving them alone", [0]

    def sweep() -> float:
        with tempfile.TemporaryDirectory() as home:
            took, peak = run(Path(home), f"0-{SEEDS - 1}")
        peaks.append(peak)
        return took

    with tempfile.TemporaryDirectory() as warm:
        run(Path(warm), "0-1")  # so that all is compiled
    timing = interleave(given.rounds or ROUNDS, {name: sweep, alone: lambda: seconds(solve)})
    yield timing.row(name, alone, unit="s")
    yield Row(name=f"{name}, memory of all processes", value=max(peaks) / 1e6, unit="MB")


def solve() -> None:
    """Solve what the sweep solves, and keep nothing."""
    for name in MAPS:
        for algo in ALGOS:
            solve_many(name, algo, range(SEEDS))


def run(home: Path, seeds: str) -> tuple[float, int]:
    """Return the seconds that a sweep took, and the most memory in bytes that its processes held at once."""
    began, peak = time.perf_counter(), 0
    command = [sys.executable, "-m", "acoexp", *SWEEP, f"seeds={seeds}"]
    process = subprocess.Popen(command, cwd=home, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    watched = psutil.Process(process.pid)
    while process.poll() is None:
        try:
            peak = max(peak, sum(p.memory_info().rss for p in [watched, *watched.children(recursive=True)]))
        except psutil.NoSuchProcess:
            continue
        time.sleep(0.02)
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
    return time.perf_counter() - began, peak
