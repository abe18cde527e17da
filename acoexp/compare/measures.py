"""What is measured of each configuration, and of each two, on one map; plain rows for every table and file."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import numpy as np

from acoexp.compare import statistics
from acoexp.compare.sample import Row, Sample
from acoexp.compare.statistics import SIGNIFICANCE
from acoexp.grid.grid import Grid
from acoexp.trial.features import NAMES, defined
from acoexp.trial.trials import Trials


def measured(configuration: str, grid: Grid, trials: Trials) -> Sample:
    """Return what is measured of a configuration's trials on a map."""
    table = trials.table
    return Sample(
        configuration=configuration,
        map=grid.name,
        optimum=grid.optimum,
        found=table["l1"] == grid.optimum,
        features={name: defined(name, table[name]) for name in NAMES},
        curves=trials.curves,
        steps=trials.cycle_steps.cumsum(axis=1, dtype=np.int64),
    )


def configuration_row(sample: Sample) -> Row:
    """Return a configuration's features as mean and deviation, its success rate and expected running time."""
    names = {"map": sample.map, "cell": sample.configuration}
    row: Row = {**names, "trials": sample.found.size, "optimum": sample.optimum}
    for name in NAMES:
        row[name], row[f"{name}_sd"] = statistics.mean_and_deviation(sample.features[name])
    rate = statistics.success_rate(sample.found)
    spent = np.where(sample.found, sample.features["x1"], sample.features["cycles"])
    time = statistics.expected_running_time(spent, sample.found)
    row |= {"found": int(sample.found.sum()), "success": rate.value, "success_low": rate.low}
    return row | {"success_high": rate.high, "ert": time.value, "ert_low": time.low, "ert_high": time.high}


def pair_rows(samples: Sequence[Sample]) -> list[Row]:
    """Return what is compared between each two configurations on each map, corrected over all of it together."""
    pairs = [(a, b) for a, b in combinations(samples, 2) if a.map == b.map]
    rows = [row for a, b in pairs for row in (*_ranked(a, b), _success(a, b))]
    corrected = statistics.holm([row["p"] for row in rows])
    for row, p_holm in zip(rows, corrected, strict=True):
        row |= {"p_holm": p_holm, "verdict": _verdict(row, p_holm)}
    return rows


def _ranked(a: Sample, b: Sample) -> list[Row]:
    """Compare the lengths of convergence, and the hitting times with what is censored at the end."""
    censored = max(a.iterations, b.iterations) + 1
    lengths = np.concatenate([a.features["l2"], b.features["l2"], [a.optimum]])
    worst = float(np.nanmax(lengths)) + 1.0
    measures = {
        "l2": (a.convergence(worst), b.convergence(worst)),
        "hitting time": (a.hitting_time(censored), b.hitting_time(censored)),
    }
    return [
        _row(a, b, name, "A12", statistics.superiority(*both), "sign test", statistics.sign_test(*both))
        for name, both in measures.items()
    ]


def _success(a: Sample, b: Sample) -> Row:
    ratio = statistics.odds_ratio(a.found, b.found)
    return _row(a, b, "success", "odds ratio", ratio, "McNemar", statistics.sign_test(a.found, b.found))


def _row(
    a: Sample, b: Sample, measure: str, effect: str, estimate: statistics.Estimate, test: str, p: float
) -> Row:
    names = {"map": a.map, "a": a.configuration, "b": b.configuration, "measure": measure, "effect": effect}
    return {**names, "value": estimate.value, "low": estimate.low, "high": estimate.high, "test": test, "p": p}


def _verdict(row: Row, p_holm: float) -> str:
    """Say in plain words what is shown at 5 %; both effects are larger where ``a`` is better."""
    neutral = 0.5 if row["effect"] == "A12" else 1.0
    if p_holm >= SIGNIFICANCE or row["value"] == neutral:
        return "no difference shown"
    return f"{row['a'] if row['value'] > neutral else row['b']} better"
