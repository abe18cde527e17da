"""What was measured, as plain rows for every table, file and picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import scipy  # scipy.stats is imported when first used: it is a fifth of what a command costs to start

from acoexp.sensitivity.design import Level
from acoexp.sensitivity.outcomes import OUTCOMES, Array, Measured
from acoexp.sensitivity.shares import LEVEL, RESAMPLES, Share, Shares

Row = dict[str, Any]

TOGETHER, SEEDS = "several keys together", "seeds"
"""What else explains an outcome's variance, beside single keys."""


def share_rows(keys: Sequence[str], shares: Mapping[str, Shares | None]) -> list[Row]:
    """Return one row for each outcome and each key, then what several explain together, and the seeds alone.

    Numbers are nan where an outcome has no variance, and the total and the rank where there is none.
    """
    rows = []
    for outcome, found in shares.items():
        nothing = Share(np.nan, np.nan, np.nan)
        k = len(keys)
        alone = [nothing] * (k + 2) if found is None else [*found.alone, found.together, found.seeds]
        total = [nothing] * (k + 2) if found is None else [*found.total, nothing, nothing]
        first = [np.nan] * (k + 2) if found is None else [*map(float, found.first), np.nan, np.nan]
        rows += [
            {
                **{"outcome": outcome, "source": source},
                **{"alone": a.value, "alone_low": a.low, "alone_high": a.high},
                **{"total": t.value, "total_low": t.low, "total_high": t.high, "first": rank},
            }
            for source, a, t, rank in zip([*keys, TOGETHER, SEEDS], alone, total, first, strict=True)
        ]
    return rows


def curve_rows(levels: Sequence[Level], measured: Sequence[Measured], worst: float) -> list[Row]:
    """Return one row for each point of the curves: means over trials with intervals, and the expected cycles.

    Args:
        levels: The points.
        measured: What their trials came to.
        worst: The gap of a trial in which no ant arrived.
    """
    rows = []
    for level, one in zip(levels, measured, strict=True):
        row: Row = {"key": level.key, "value": level.value, "trials": one.found.size}
        row["never_arrived"] = one.never_arrived
        for name, values in one.with_gap(worst).items():
            low, high = _proportion(one) if name == "found" else _interval_of_mean(values)
            row |= {name: float(values.mean()), f"{name}_low": low, f"{name}_high": high}
        rows.append(row | {"expected_cycles": one.expected_cycles})
    return rows


def point_rows(points: Sequence[Mapping[str, float]], measured: Sequence[Measured], size: int) -> list[Row]:
    """Return one row for each point of the design, sample by sample of ``size``, with its outcomes' means.

    The gap is empty where no ant arrived in any of a point's trials, else the mean of those in which one did.
    """
    names = ["A", "B", *(f"A with {key} of B" for key in points[0])]
    return [
        {
            **{"sample": names[place // size], "trials": one.found.size, "never_arrived": one.never_arrived},
            **point,
            **{outcome: _mean_of_known(one.outcomes[outcome]) for outcome in OUTCOMES},
        }
        for place, (point, one) in enumerate(zip(points, measured, strict=True))
    ]


def _mean_of_known(values: Array) -> float:
    known = values[~np.isnan(values)]
    return float(known.mean()) if known.size else np.nan


def _proportion(measured: Measured) -> tuple[float, float]:
    """Return Wilson's interval of the share of successes, in percent."""
    test = scipy.stats.binomtest(int(measured.found.sum()), measured.found.size)
    interval = test.proportion_ci(LEVEL, method="wilson")
    return 100.0 * float(interval.low), 100.0 * float(interval.high)


def _interval_of_mean(values: Array) -> tuple[float, float]:
    """Return the bootstrap's percentile interval of a mean, the same at every call."""
    drawn = np.random.default_rng(0).integers(values.size, size=(RESAMPLES, values.size))
    low, high = np.quantile(values[drawn].mean(axis=1), ((1.0 - LEVEL) / 2.0, (1.0 + LEVEL) / 2.0))
    return float(low), float(high)
