"""Merge: finished runs of another store are brought into this one, each identity once."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import urlsplit
from urllib.request import url2pathname

from acoexp.errors import TrackingError
from acoexp.tracking.mlflow.run import ALIVE, IDENTITY, OWNER, WRITER, RunWriter
from acoexp.tracking.mlflow.store import Store

if TYPE_CHECKING:
    from mlflow.entities import Metric, Run

_MADE_BY_WRITER = {OWNER, WRITER, ALIVE}


class Merged(NamedTuple):
    """What became of the runs of a store.

    Attributes:
        brought: Runs that were copied.
        known: Finished runs whose identity was there already.
        left: Runs that are not finished, or of no identity.
    """

    brought: int
    known: int
    left: int


def merge(source: Store, target: Store, show: Callable[[int, int], None] = lambda done, all: None) -> Merged:
    """Copy what is finished in a source store, and not in the target, into the target.

    Args:
        source: The store to read; it is not changed.
        target: The store to write, prepared.
        show: Called after each run with how many are done, and of how many.

    Raises:
        TrackingError: if a store cannot be read or written, or a run's artifacts are not to be found. What was
            brought before stays, whole; the same merge again brings the rest.
    """
    runs = source.with_retries(lambda: source.search(""), "cannot be searched")
    finished = [run for run in runs if run.info.status == "FINISHED" and IDENTITY in run.data.tags]
    here = target.with_retries(lambda: target.search("attributes.status = 'FINISHED'"), "cannot be searched")
    known = {run.data.tags.get(IDENTITY) for run in here}
    missing = {run.data.tags[IDENTITY]: run for run in finished if run.data.tags[IDENTITY] not in known}
    for done, run in enumerate(missing.values(), 1):
        _copy(source, target, run)
        show(done, len(missing))
    return Merged(len(missing), len(finished) - len(missing), len(runs) - len(finished))


def _copy(source: Store, target: Store, run: Run) -> None:
    tags = {k: v for k, v in run.data.tags.items() if k not in _MADE_BY_WRITER}
    name = run.info.run_name or ""
    with tempfile.TemporaryDirectory() as folder:
        artifacts = _artifacts(source, run, Path(folder))  # first, so that a run without them is not begun
        writer = RunWriter(target, name, run.data.params, tags, started=run.info.start_time)
        try:
            writer.begin(_metrics(source, run))
            if artifacts is not None:
                for file in sorted(path for path in artifacts.rglob("*") if path.is_file()):
                    inside = file.parent.relative_to(artifacts).as_posix()
                    writer.log_file(file, None if inside == "." else inside)
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


def _artifacts(source: Store, run: Run, folder: Path) -> Path | None:
    """Return a folder with a run's artifacts, fetched into ``folder`` if need be; None if it has none.

    A store that was copied from another machine names folders of that machine; they are looked for beside its
    database then.
    """
    address = urlsplit(run.info.artifact_uri)
    if address.scheme not in ("", "file"):
        run_id = run.info.run_id
        return Path(
            source.with_retries(
                lambda: source.client.download_artifacts(run_id, "", str(folder)), "cannot be read"
            )
        )
    named = Path(url2pathname(address.path))
    beside = source.folder / "artifacts" / Path(*named.parts[-2:]) if source.folder is not None else named
    for place in (named, beside):
        if place.is_dir():
            return place
    if "trials" in run.data.metrics:
        raise TrackingError(
            f"run {run.info.run_id} of {source.shown}: expected its artifacts in {named} or {beside}; got neither"
        )
    return None
