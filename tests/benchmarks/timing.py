"""Both sides of a ratio by turns, so that a drifting clock meets each alike."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from statistics import median, quantiles
from typing import Any

from rows import Row

PER_SECOND = {"s": 1.0, "ms": 1e3, "ns": 1e9}


class Timing(dict[str, list[float]]):
    """Seconds by name, one value a round."""

    def row(self, job: str, base: str = "", /, *, unit: str, **said: Any) -> Row:
        """Return the row of one side beside another, if there is one; ``said`` are other fields of the row."""
        ratios = [a / b for a, b in zip(self[job], self[base], strict=True)] if base else []
        ratio = median(ratios) if ratios else None
        row = {"name": job, "value": median(self[job]) * PER_SECOND[unit], "unit": unit}
        return Row(**(row | {"ratio": ratio, "base": base, "spread": spread(ratios)} | said))


def interleave(rounds: int, jobs: Mapping[str, Callable[[], float]]) -> Timing:
    """Run all jobs in turn, over and over; each returns its own seconds."""
    timing = Timing({name: [] for name in jobs})
    for _ in range(rounds):
        for name, job in jobs.items():
            timing[name].append(job())
    return timing


def spread(values: Sequence[float]) -> float:
    """Return half the range of the middle half of values, as a share of their median; of few, of all of them."""
    if len(values) < 2:
        return 0.0
    low, _, high = quantiles(values) if len(values) > 3 else (min(values), 0.0, max(values))
    return (high - low) / 2.0 / median(values)


def seconds(job: Callable[[], object]) -> float:
    """Return how long a job takes."""
    began = time.perf_counter()
    job()
    return time.perf_counter() - began


def processor_seconds(command: Sequence[str], folder: Path | str, env: Mapping[str, str] | None = None) -> float:
    """Return the processor time of a command and all that it starts and waits for."""
    began = getrusage(RUSAGE_CHILDREN)
    subprocess.run(command, cwd=folder, env=env, check=True, capture_output=True)
    ended = getrusage(RUSAGE_CHILDREN)
    return ended.ru_utime + ended.ru_stime - began.ru_utime - began.ru_stime
