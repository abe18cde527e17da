"""What a run says besides its parameters: metrics and tags."""

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

from acoexp.trial.features import CYCLES
from acoexp.trial.result import Result
from acoexp.trial.table import Aggregates

if TYPE_CHECKING:
    from mlflow.entities import Metric


def trial_metrics(result: Result) -> Iterator[Metric]:
    """Yield the metrics of a trial: its features where defined, its optimum, its curve."""
    features = {name: math.nan if name in CYCLES and not v else v for name, v in result.features._asdict().items()}
    others = {"optimum": result.optimum, "lost_ants": float(result.lost_ants.sum())}
    yield from _points({**features, **others}, result.curve)


def batch_metrics(
    summary: Aggregates, curve: NDArray[np.float64], failed: int, optimum: float
) -> Iterator[Metric]:
    """Yield the metrics of a batch: its aggregates, and the mean of its curves."""
    values: dict[str, float] = {
        **summary.means,
        **{f"{name}_sd": value for name, value in summary.deviations.items()},
        "optimum": optimum,
        "trials": summary.trials,
        "never_arrived": summary.never_arrived,
        "failed": failed,
        "success_rate": summary.success_rate,
        "expected_cycles": summary.expected_cycles,
    }
    yield from _points(values, curve)


def _points(values: Mapping[str, float], curve: NDArray[np.float64]) -> Iterator[Metric]:
    """Yield metrics, and the curve with the cycle as its step; nothing for what is undefined."""
    from mlflow.entities import Metric

    now = int(time.time() * 1000)
    for key, value in values.items():
        if not math.isnan(value):
            yield Metric(key, value, now, 0)
    for cycle, length in enumerate(curve.tolist(), 1):
        if not math.isnan(length):
            yield Metric("best_length", length, now, cycle)


def versions(packages: Mapping[str, str]) -> dict[str, str]:
    """Return which code is at work, as tags.

    Args:
        packages: The package of the part in each group, with its version.
    """
    tags = {"acoexp.version": version("acoexp"), **{f"{group}.package": name for group, name in packages.items()}}
    commit = _git_commit()
    return {**tags, "mlflow.source.git.commit": commit} if commit else tags


@cache
def _git_commit() -> str | None:
    """Return the commit of the working directory, if it is in a repository."""
    try:
        return check_output(["git", "rev-parse", "HEAD"], stderr=DEVNULL, text=True, timeout=5).strip()
    except (OSError, SubprocessError):
        return None
