"""Rows: what jobs found, read from their records, gathered by configuration for the table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from acoexp.trial.features import NAMES
from acoexp.trial.table import TABLE, Aggregates, aggregate


class Row(NamedTuple):
    """What the trials of one configuration found.

    Attributes:
        algo: Label of the algorithm.
        map: The map's name.
        config: The configuration, flattened.
        optimum: Exact optimum, in cells.
        summary: What the trials say together.
        found: How many found the optimum.
        milliseconds: Mean time of a trial; nan where all came from the store.
        lost_after: Moves after which an ant was lost, on average, in trials in which none ever arrived; nan where
            there is none, or all such came from the store.
    """

    algo: str
    map: str
    config: Mapping[str, str]
    optimum: float
    summary: Aggregates
    found: int
    milliseconds: float
    lost_after: float


def rows_of(records: Iterable[Mapping[str, Any]]) -> list[Row]:
    """Return a row for each configuration among the records of trials, and one for each batch, in order."""
    groups: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for record in sorted(records, key=_order):
        key = record["configuration_id"], record["config"].get("seeds", "")
        groups.setdefault(key, []).append(record)
    return [_of_batch(group[0]) if "means" in group[0] else _of_trials(group) for group in groups.values()]


def _of_batch(record: Mapping[str, Any]) -> Row:
    summary = Aggregates(**{name: _with_nan(record[name]) for name in Aggregates._fields})
    return Row(
        *_head(record),
        summary=summary,
        found=round(summary.success_rate * summary.trials),
        milliseconds=1000.0 * (math.nan if record["seconds"] is None else record["seconds"]),
        lost_after=_mean_of([record], "lost_after"),
    )


def _with_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _with_nan(inner) for key, inner in value.items()}
    return math.nan if value is None else value


def _of_trials(records: list[Mapping[str, Any]]) -> Row:
    table = np.zeros(len(records), TABLE)
    for row, record in zip(table, records, strict=True):
        for name in NAMES:
            row[name] = _feature(name, record.get(name))
    optimum = records[0]["optimum"]
    return Row(
        *_head(records[0]),
        summary=aggregate(table, optimum),
        found=int((table["l1"] == optimum).sum()),
        milliseconds=1000.0 * _mean_of(records, "seconds"),
        lost_after=_mean_of(records, "lost_after"),
    )


def _mean_of(records: Iterable[Mapping[str, Any]], name: str) -> float:
    """Return the mean over the records that have a value; nan if none has."""
    values = [record[name] for record in records if record.get(name) is not None]
    return float(np.mean(values)) if values else math.nan


def _feature(name: str, value: Any) -> float:
    """Return a feature of a record as a table has it."""
    if isinstance(value, list):  # lost ants, cycle by cycle
        return float(sum(value))
    if value is None:
        return math.nan if TABLE[name].kind == "f" else 0.0
    return float(value)


def _head(record: Mapping[str, Any]) -> tuple[str, str, Mapping[str, str], float]:
    return record["algo"], record["map"], record["config"], record["optimum"]


def _order(record: Mapping[str, Any]) -> list[tuple[float, str]]:
    """Return what rows are sorted by: map, algorithm, then every setting, numbers as numbers."""
    values = [record["map"], record["algo"], *record["config"].values(), str(record.get("seed", ""))]
    return [_place(value) for value in values]


def _place(value: str) -> tuple[float, str]:
    """Return where a value stands: numbers by their size, before all texts; ``2024.05.01`` is a text."""
    try:
        return (float(value), "") if math.isfinite(float(value)) else (math.inf, value)
    except ValueError:
        return math.inf, value
