"""Merge: finished runs of another store are brought into this one, each identity once."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from acoexp.errors import StoreGoneError, TrackingError
from acoexp.merge.artifacts import artifacts_of
from acoexp.tracking.mlflow.run import ALIVE, IDENTITY, OWNER, REPLACES, WRITER, RunWriter
from acoexp.tracking.mlflow.store import Store

if TYPE_CHECKING:
    from mlflow.entities import Metric, Run

_NOT_BROUGHT = {OWNER, WRITER, ALIVE, REPLACES}
"""Tags that say who writes a run, and that it takes the place of another: in its own store."""

_NAMED = 20
"""Runs that a message names."""

_LONGEST = 500
"""Characters of each reason that a message shows: whoever wrote a store chose the names in it."""

_IDENTITY = re.compile("[0-9a-f]{32}")
"""It is put into questions to the store, so nothing else may be in it."""


class Merged(NamedTuple):
    """What became of the runs of a store.

    Attributes:
        brought: Runs that were copied.
        known: Finished runs whose identity was there already.
        left: Runs that are not finished, or of no identity.
        refused: Runs that were to be copied and were not.
    """

    brought: int
    known: int
    left: int
    refused: int = 0


class RefusedError(TrackingError):
    """Some runs were refused; all others were brought.

    Attributes:
        merged: What became of all of them.
    """

    def __init__(self, merged: Merged, reasons: Sequence[str]) -> None:
        more = f"; and {len(reasons) - _NAMED} more" if len(reasons) > _NAMED else ""
        super().__init__("; ".join(reasons[:_NAMED]) + more)
        self.merged = merged


def merge(source: Store, target: Store, show: Callable[[int, int], None] = lambda done, all: None) -> Merged:
    """Copy what is finished in a source store, and not in the target, into the target.

    Args:
        source: The store to read; it is not changed.
        target: The store to write, prepared.
        show: Called after each run with how many are done, and of how many.

    Raises:
        RefusedError: if runs cannot be brought, such as for artifacts that are no files of the store's own; all
            others are.
        TrackingError: if a store cannot be read or written. What was brought before stays, whole; the same merge
            again brings the rest.
    """
    runs = source.with_retries(lambda: source.search(""), "cannot be searched")
    finished = [run for run in runs if run.info.status == "FINISHED" and _is_known(run)]
    here = target.with_retries(lambda: target.search("attributes.status = 'FINISHED'"), "cannot be searched")
    known = {run.data.tags.get(IDENTITY) for run in here}
    missing = {run.data.tags[IDENTITY]: run for run in finished if run.data.tags[IDENTITY] not in known}
    refused: list[str] = []
    for done, run in enumerate(missing.values(), 1):
        try:
            _copy(source, target, run)
        except StoreGoneError:
            raise
        except TrackingError as problem:  # this run's own; whoever wrote the store may have written anything
            refused.append(f"run {run.info.run_id} of {source.shown}: {_shortened(str(problem))}")
        show(done, len(missing))
    there = len(finished) - len(missing)
    merged = Merged(len(missing) - len(refused), there, len(runs) - len(finished), len(refused))
    if refused:
        raise RefusedError(merged, refused)
    return merged


def _shortened(reason: str) -> str:
    return reason if len(reason) <= _LONGEST else f"{reason[:_LONGEST]} ..."


def _is_known(run: Run) -> bool:
    return _IDENTITY.fullmatch(run.data.tags.get(IDENTITY, "")) is not None


def _copy(source: Store, target: Store, run: Run) -> None:
    tags = {k: v for k, v in run.data.tags.items() if k not in _NOT_BROUGHT}
    name = run.info.run_name or ""
    with tempfile.TemporaryDirectory() as folder:
        artifacts = artifacts_of(source, run, Path(folder))  # first, so that a run without them is not begun
        writer = RunWriter(target, name, run.data.params, tags, started=run.info.start_time)
        try:
            writer.begin(_metrics(source, run))
            for file, inside in artifacts:
                writer.log_file(file, inside)
            writer.finish(run.info.end_time)
        except BaseException as problem:
            writer.abort(str(problem) or type(problem).__name__)
            raise


def _metrics(source: Store, run: Run) -> list[Metric]:
    """Return all points of all of a run's metrics."""

    def history() -> list[Metric]:
        client, run_id = source.client, run.info.run_id
        return [point for key in run.data.metrics for point in client.get_metric_history(run_id, key)]

    return source.with_retries(history, "cannot be read")
