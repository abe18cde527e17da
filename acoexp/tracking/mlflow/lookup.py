"""Runs of a local database, read from its tables: MLflow takes seconds to import, and two milliseconds to
load a run.

As in ``moving``, this is SQL over MLflow's own tables, and a test holds it against what MLflow itself finds.
"""

from __future__ import annotations

import json
import math
from collections.abc import Collection
from pathlib import Path
from typing import Literal, NamedTuple

from acoexp.tracking.mlflow.database import kept_open

_RUNS = """
SELECT runs.run_uuid, runs.start_time, runs.status
FROM tags JOIN runs USING (run_uuid) JOIN experiments USING (experiment_id)
WHERE tags.key = ? AND tags.value IN (SELECT value FROM json_each(?))
  AND experiments.{by} = ? AND experiments.lifecycle_stage = 'active'
  AND runs.lifecycle_stage = 'active'
ORDER BY runs.start_time
"""
_TAGS = "SELECT run_uuid, key, value FROM tags WHERE run_uuid IN (SELECT value FROM json_each(?))"
_METRICS = (
    "SELECT run_uuid, key, value, is_nan FROM latest_metrics WHERE run_uuid IN (SELECT value FROM json_each(?))"
)


class LocalInfo(NamedTuple):
    """What is known of a run, by MLflow's names."""

    run_id: str
    start_time: int
    status: str


class LocalData(NamedTuple):
    """What a run says, by MLflow's names."""

    tags: dict[str, str]
    metrics: dict[str, float]


class LocalRun(NamedTuple):
    """A run, in the shape of MLflow's own."""

    info: LocalInfo
    data: LocalData


def runs_with(
    file: Path,
    experiment: str,
    tag: str,
    values: Collection[str],
    by: Literal["name", "experiment_id"] = "name",
) -> list[LocalRun]:
    """Return the runs of an experiment whose tag has one of some values, the oldest first.

    Raises:
        sqlite3.Error: if the database is not there, is none of MLflow's, or is locked.
    """
    database = kept_open(file)
    found = database.execute(_RUNS.format(by=by), (tag, json.dumps([*values]), experiment)).fetchall()
    runs = {row[0]: LocalRun(LocalInfo(row[0], row[1] or 0, row[2]), LocalData({}, {})) for row in found}
    ids = json.dumps([*runs])
    for run_id, key, value in database.execute(_TAGS, (ids,)):
        runs[run_id].data.tags[key] = value
    for run_id, key, value, is_nan in database.execute(_METRICS, (ids,)):
        number = isinstance(value, int | float) and not is_nan  # a person may have written a text there
        runs[run_id].data.metrics[key] = float(value) if number else math.nan
    return [*runs.values()]
