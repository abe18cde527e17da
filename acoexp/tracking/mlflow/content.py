"""What a run says besides its parameters: metrics, tags, and a description."""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping
from functools import cache
from importlib.metadata import version
from subprocess import DEVNULL, SubprocessError, check_output
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.trial.features import CYCLES, best_so_far
from acoexp.trial.outcome import Batch
from acoexp.trial.quality import in_metres
from acoexp.trial.result import Result
from acoexp.trial.settings import Settings
from acoexp.trial.table import aggregate

if TYPE_CHECKING:
    from mlflow.entities import Metric


def trial_metrics(result: Result, seconds: float = math.nan) -> Iterator[Metric]:
    """Yield the metrics of a trial that took so long: what is measured of it, where defined, and its curves."""
    features = {name: math.nan if name in CYCLES and not v else v for name, v in result.features._asdict().items()}
    quality = result.quality._asdict()
    others = {
        "cycles": result.cycles,
        "lost_ants": float(result.lost_ants.sum()),
        "ant_steps": result.ant_steps,
        "seconds": seconds,
    }
    values = {**features, **quality, **in_metres(quality, result.grid.frame), **others, **_bounds(result.grid)}
    yield from _points(values, result.curve, best_so_far(result.curve))


def batch_metrics(batch: Batch, grid: Grid) -> Iterator[Metric]:
    """Yield the metrics of a batch on a map with a finished trial: its aggregates, and the means of its curves."""
    summary = aggregate(batch.table, grid.optimum)
    values: dict[str, float] = {
        **summary.means,
        **{f"{name}_sd": value for name, value in summary.deviations.items()},
        **in_metres(summary.means, grid.frame),
        **_bounds(grid),
        "trials": summary.trials,
        "never_arrived": summary.never_arrived,
        "failed": len(batch.failures),
        "success_rate": summary.success_rate,
        "expected_cycles": summary.expected_cycles,
        "seconds": batch.seconds / batch.ran if batch.ran else math.nan,
    }
    yield from _points(values, batch.curve, batch.best)


def _bounds(grid: Grid) -> dict[str, float]:
    return {"optimum": grid.optimum, "any_angle_optimum": grid.any_angle_optimum}


def _points(
    values: Mapping[str, float], curve: NDArray[np.float64], best: NDArray[np.float64]
) -> Iterator[Metric]:
    """Yield metrics, and both curves with the cycle as their step; nothing for what is undefined."""
    from mlflow.entities import Metric

    now = int(time.time() * 1000)
    for key, value in values.items():
        if not math.isnan(value):
            yield Metric(key, value, now, 0)
    # the best so far changes seldom: a line between the ends of its steps is all of it, at a tenth of the cost
    bends = np.flatnonzero(np.diff(best, prepend=np.nan, append=np.nan)[:-1] != 0) if best.size else best
    ends = np.union1d(bends, np.append(bends[1:] - 1, best.size - 1)).astype(np.int64)
    for key, lengths, cycles in (("cycle_length", curve, range(curve.size)), ("best_length", best, ends.tolist())):
        for cycle in cycles:
            if not math.isnan(lengths[cycle]):
                yield Metric(key, float(lengths[cycle]), now, cycle + 1)


def description(settings: Settings, grid: Grid, command: str | None, seeds: str) -> str:
    """Return what a run is of, in Markdown: map, algorithm, and the command that runs it again.

    Args:
        settings: The configuration.
        grid: The map.
        command: The command that runs it again, if there is one.
        seeds: Its seed or seeds, such as ``seed 3``.
    """
    rows, cols = grid.shape
    parts = ", ".join(f"{group} {chosen.name}" for group, chosen in settings.chosen.items())
    lines = [
        f"{settings.label} on {grid.name}, {seeds}",
        f"Map: {grid.name}, {rows} x {cols} cells, moves {grid.moves}, exact optimum {grid.optimum:.4f}, digest "
        f"{grid.digest}",
        f"Algorithm: {settings.label}: {parts}",
    ]
    if command is not None:
        lines += ["The command that runs it again:", f"    {command}"]
    return "\n\n".join(lines)


def versions(packages: Mapping[str, str]) -> dict[str, str]:
    """Return which code is at work, as tags.

    Args:
        packages: The package of the part in each group, with its version.
    """
    tags = {"acoexp.version": _own_version(), **{f"{group}.package": name for group, name in packages.items()}}
    commit = _git_commit()
    return {**tags, "mlflow.source.git.commit": commit} if commit else tags


@cache
def _own_version() -> str:
    return version("acoexp")


@cache
def _git_commit() -> str | None:
    """Return the commit of the working directory, if it is in a repository."""
    try:
        return check_output(["git", "rev-parse", "HEAD"], stderr=DEVNULL, text=True, timeout=5).strip()
    except (OSError, SubprocessError):
        return None
