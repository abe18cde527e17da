"""Runs that were left behind: begun by a process that was killed, and closed by whoever opens the store next."""

from __future__ import annotations

import time
from contextlib import suppress
from typing import TYPE_CHECKING

from acoexp.tracking.mlflow.owner import is_dead, is_mark
from acoexp.tracking.mlflow.run import ALIVE, IDENTITY, OWNER, WRITER, mark_failed, unless_gone
from acoexp.tracking.mlflow.store import Store

if TYPE_CHECKING:
    from mlflow.entities import Run

SILENT_FOR = 600.0
"""Seconds without a sign of life after which a run that another machine began is taken for left behind."""


def close_left_behind(store: Store) -> None:
    """Mark runs as failed that no process writes any more.

    Whatever else is in the experiment is left alone, and so is a run of ours that a person made another's.
    """
    for run in store.search("attributes.status = 'RUNNING'"):
        if _is_left_behind(run) and store.client.get_run(run.info.run_id).info.status == "RUNNING":
            with unless_gone():
                mark_failed(store, run.info.run_id, "left behind by a process that was killed")


def _is_left_behind(run: Run) -> bool:
    tags = run.data.tags
    if not {IDENTITY, OWNER, WRITER} <= tags.keys() or not is_mark(tags[OWNER]):
        return False
    dead = is_dead(tags[OWNER])
    return dead or (dead is None and time.time() - _last_sign(run) > SILENT_FOR)


def _last_sign(run: Run) -> float:
    """Return when a run's process last said that it lives; when it began, where somebody wrote over that."""
    with suppress(ValueError):
        return float(run.data.tags.get(ALIVE, "")) / 1000.0
    return float(run.info.start_time) / 1000.0
