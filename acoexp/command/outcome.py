"""Outcomes: what jobs found, read from their records or from the store, gathered by cell for the table."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from acoexp.command.records import BATCH, PROGRESS, TRIAL
from acoexp.tracking import Found, Setup
from acoexp.trials import TABLE, Aggregates, aggregate

_FEATURES = ("x1", "x2", "x3", "l1", "l2", "lost_ants")


class Outcome(NamedTuple):
    """What the trials of one cell found.

    Attributes:
        algo: Label of the algorithm.
        map: The map's name.
        config: The configuration, flattened.
        optimum: Exact optimum, in cells.
        summary: What the trials say together.
        found: How many found the optimum.
        milliseconds: Mean time of a trial; nan where all came from the store.
    """

    algo: str
    map: str
    config: Mapping[str, str]
    optimum: float
    summary: Aggregates
    found: int
    milliseconds: float


def finished(folder: Path) -> dict[Path, int]:
    """Return the records of finished jobs below a folder, each with the time it was written, in ns."""
    return {file: file.stat().st_mtime_ns for name in (TRIAL, BATCH) for file in folder.rglob(name)}


def trials_done(folder: Path, records: Iterable[Path]) -> int:
    """Return how many trials are done below a folder, those of unfinished batches too."""
    return in_progress(folder) + sum(record.name == TRIAL for record in records)


def in_progress(folder: Path, finished: bool = True) -> int:
    """Return how many trials of batches are done below a folder, also of those that are finished or not."""
    files = (file for file in folder.rglob(PROGRESS) if finished or not file.with_name(BATCH).exists())
    return sum(int(file.read_text(encoding="utf-8")) for file in files)


def read(file: Path) -> dict[str, Any]:
    """Return a record as it was written."""
    record: dict[str, Any] = json.loads(file.read_text(encoding="utf-8"))
    return record


def record_of(setup: Setup, found: Found) -> dict[str, Any]:
    """Return the record of a run that was found in the store."""
    metrics = found.metrics
    record = {
        "algo": setup.settings.label,
        "map": setup.grid.name,
        "cell": setup.cell,
        "config": dict(found.params),
        "optimum": setup.grid.optimum,
        "seconds": None,
    }
    if "seeds" not in found.params:
        values = {name: metrics.get(name) for name in _FEATURES}
        return {**record, **values, "seed": found.params["seed"], "lost_ants": [values["lost_ants"]]}
    summary = Aggregates(
        trials=found.trials,
        never_arrived=int(metrics["never_arrived"]),
        success_rate=metrics["success_rate"],
        expected_cycles=metrics.get("expected_cycles", math.nan),
        means={name: metrics.get(name, math.nan) for name in _FEATURES},
        deviations={name: metrics.get(f"{name}_sd", math.nan) for name in _FEATURES},
    )
    return {**record, **summary._asdict()}


def outcomes(records: Iterable[Mapping[str, Any]]) -> list[Outcome]:
    """Return one outcome for each cell among the records of trials, and one for each batch, in order."""
    cells: dict[tuple[str, str], list[Mapping[str, Any]]] = {}
    for record in sorted(records, key=_order):
        cells.setdefault((record["cell"], record["config"].get("seeds", "")), []).append(record)
    return [_of_batch(c[0]) if "means" in c[0] else _of_trials(c) for c in cells.values()]


def _of_batch(record: Mapping[str, Any]) -> Outcome:
    summary = Aggregates(**{name: _with_nan(record[name]) for name in Aggregates._fields})
    return Outcome(
        *_said(record),
        summary=summary,
        found=round(summary.success_rate * summary.trials),
        milliseconds=1000.0 * (math.nan if record["seconds"] is None else record["seconds"]),
    )


def _with_nan(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _with_nan(inner) for key, inner in value.items()}
    return math.nan if value is None else value


def _of_trials(records: list[Mapping[str, Any]]) -> Outcome:
    table = np.zeros(len(records), TABLE)
    for row, record in zip(table, records, strict=True):
        for name in ("x1", "x2", "x3"):
            row[name] = record[name] or 0
        for name in ("l1", "l2"):
            row[name] = math.nan if record[name] is None else record[name]
        row["lost_ants"] = sum(record["lost_ants"])
    optimum = records[0]["optimum"]
    seconds = [record["seconds"] for record in records if record["seconds"] is not None]
    return Outcome(
        *_said(records[0]),
        summary=aggregate(table, optimum, 0)._replace(expected_cycles=math.nan),  # not in the table
        found=int((table["l1"] == optimum).sum()),
        milliseconds=1000.0 * float(np.mean(seconds)) if seconds else math.nan,
    )


def _said(record: Mapping[str, Any]) -> tuple[str, str, Mapping[str, str], float]:
    return record["algo"], record["map"], record["config"], record["optimum"]


def _order(record: Mapping[str, Any]) -> list[tuple[float, str]]:
    """Return what rows are sorted by: map, algorithm, then every setting, numbers as numbers."""
    values = [record["map"], record["algo"], *record["config"].values(), str(record.get("seed", ""))]
    return [(float(v), "") if re.fullmatch(r"-?[\d.]+(e[+-]?\d+)?", v) else (math.inf, v) for v in values]
