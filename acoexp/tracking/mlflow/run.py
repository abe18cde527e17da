"""One run in the store: written piece by piece, finished at the end, and alone of its identity then."""

from __future__ import annotations

import math
import re
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import cached_property
from pathlib import Path
from secrets import token_hex
from typing import TYPE_CHECKING

from acoexp.tracking.mlflow.lookup import LocalRun, runs_with
from acoexp.tracking.mlflow.masking import masked
from acoexp.tracking.mlflow.owner import this_process
from acoexp.tracking.mlflow.store import Store

if TYPE_CHECKING:
    from mlflow.entities import Metric, Run
    from mlflow.store.artifact.artifact_repo import ArtifactRepository

LONGEST_PARAM = 500
"""Characters of a parameter that every MLflow store keeps; a longer one goes to an artifact."""
LARGEST_BATCH = 1000
"""Metrics that MLflow takes in one call."""
LONGEST_TAG = 5000
"""Characters of a tag that every MLflow store keeps."""

IDENTITY, CONFIGURATION, KIND = "identity", "cell", "kind"
"""Tags: what the run is of; which configuration on which map; ``trial`` or ``batch``. They keep their names, as
stores that were written before have them."""
OWNER, WRITER, ALIVE = "owner", "writer", "alive"
"""Tags: which process writes the run, by which of its writers, and when it last did, in milliseconds."""
REPLACES = "anew"
"""Tag of a run that takes the place of what is there: when it began, in milliseconds."""
NOTE = "mlflow.note.content"
"""Tag of MLflow's: what its page says of the run, in Markdown."""
REASON = "reason"
"""Tag: why the run has failed."""
_MANY = 1e15
_METRICS = {
    "trial": {"optimum": (0.0, _MANY), "lost_ants": (0.0, _MANY)},
    "batch": {"trials": (1.0, _MANY), "never_arrived": (0.0, _MANY), "success_rate": (0.0, 1.0)},
}
"""Metrics that every finished run of a kind has, each with its least and its largest value."""
_DIGEST = re.compile("[0-9a-f]{16,64}")


class RunWriter:
    """A run that is being written."""

    def __init__(
        self,
        store: Store,
        name: str,
        params: Mapping[str, str],
        tags: Mapping[str, str],
        *,
        replace: bool = False,
        started: int | None = None,
    ) -> None:
        """Begin a run.

        Args:
            store: Where.
            name: What it is called.
            params: Its configuration, flattened.
            tags: What is known of it besides; ``IDENTITY`` among it.
            replace: Whether it takes the place of a finished run of its identity.
            started: When it began, in milliseconds since 1970; now, if that is not said.
        """
        self._store = store
        self._name, self._params, self._tags = name, params, tags
        self._started = int(_now()) if started is None else started
        if replace:
            self._tags = {**tags, REPLACES: _now()}
        self._token = token_hex(8)
        self._finished = False
        self._run_id: str | None = None
        self._artifact_uri = ""

    def begin(self, metrics: Sequence[Metric] = ()) -> None:
        """Create the run with its parameters, and with metrics where there are any yet."""
        from mlflow.entities import Param

        long = {key: value for key, value in self._params.items() if len(value) > LONGEST_PARAM}
        params = [Param(key, value) for key, value in self._params.items() if key not in long]
        client = self._store.client
        self.do(lambda run_id: client.log_batch(run_id, metrics[:LARGEST_BATCH], params))
        self.log_metrics(metrics[LARGEST_BATCH:])
        for key, value in long.items():
            self.log_text(value, f"params/{key}.txt")

    def log_metrics(self, metrics: Sequence[Metric]) -> None:
        """Keep metrics, however many."""
        for first in range(0, len(metrics), LARGEST_BATCH):
            part = metrics[first : first + LARGEST_BATCH]
            self.do(lambda run_id, part=part: self._store.client.log_batch(run_id, part))  # type: ignore[misc]

    def log_text(self, text: str, name: str) -> None:
        """Keep a text as an artifact."""
        file = Path(name)
        self.log_files({file.name: text.encode()}, None if file.parent == Path() else str(file.parent))

    def log_file(self, file: Path, folder: str | None) -> None:
        """Keep a file as an artifact in a folder."""
        self.do(lambda _: self._artifacts.log_artifact(str(file), folder))  # type: ignore[no-untyped-call]

    def log_files(self, files: Mapping[str, bytes], folder: str | None = None) -> None:
        """Keep files as artifacts in a folder, given what is in each by its name."""
        if not files:
            return
        with tempfile.TemporaryDirectory() as draft:
            for name, content in files.items():
                (Path(draft) / name).write_bytes(content)
            self.do(lambda _: self._artifacts.log_artifacts(draft, folder))  # type: ignore[no-untyped-call]

    def heartbeat(self) -> None:
        """Note that the process that writes this run is at work."""
        self.do(lambda run_id: self._store.client.set_tag(run_id, ALIVE, _now()))

    def finish(self, ended: int | None = None) -> None:
        """Say that the run is finished, and see to it that it is the only one of its identity."""
        self.do(lambda run_id: self._store.client.set_terminated(run_id, "FINISHED", ended))
        self._finished = True
        self.do(self._keep_only_this)

    def fail(self, reason: str) -> None:
        """Say that the run has failed, and why."""
        self.do(lambda run_id: mark_failed(self._store, run_id, reason))

    def abort(self, reason: str) -> None:
        """Mark the run as failed if the store takes that at once, unless it is finished; for hasty ends."""
        if self._run_id is not None and not self._finished:
            with suppress(Exception):
                mark_failed(self._store, self._run_id, reason)

    def do(self, action: Callable[[str], object]) -> None:
        """Do something with the run, given its id, again and again while the store is away."""

        def with_run() -> None:
            if self._run_id is None:
                tags = {**self._tags, OWNER: this_process(), WRITER: self._token, ALIVE: _now()}
                run = self._store.client.create_run(self._store.experiment_id, self._started, tags, self._name)
                self._run_id, self._artifact_uri = run.info.run_id, run.info.artifact_uri
            action(self._run_id)

        self._store.with_retries(with_run, "does not take a trial")

    @cached_property
    def _artifacts(self) -> ArtifactRepository:
        """Return where the run's artifacts go; MLflow's client would ask the store for the run first."""
        from mlflow.store.artifact.artifact_repository_registry import get_artifact_repository

        return get_artifact_repository(self._artifact_uri, tracking_uri=self._store.uri)

    def _keep_only_this(self, run_id: str) -> None:
        """See to it that this is the only finished run of its identity, and the only one of this writer."""
        same = self._of_same_identity()
        if all(run.info.run_id != run_id for run in same):  # a person has deleted it meanwhile
            return
        keep_one(self._store, [run for run in same if run.info.run_id == run_id or is_whole(run)])
        for run in same:
            mine = run.data.tags.get(WRITER) == self._token
            if mine and run.info.status == "RUNNING":  # made by a call whose answer was lost
                _delete(self._store, run.info.run_id)
            if run.info.run_id == run_id and REASON in run.data.tags:  # it had been taken for left behind
                with unless_gone():
                    self._store.client.delete_tag(run_id, REASON)

    def _of_same_identity(self) -> Sequence[Run | LocalRun]:
        identity, file = self._tags[IDENTITY], self._store.file
        if file is None:
            return self._store.search(f"tags.{IDENTITY} = '{identity}'")
        # by its number, as a person may rename it while the trial runs
        return runs_with(file, self._store.experiment_id, IDENTITY, [identity], by="experiment_id")


def is_whole(run: Run | LocalRun) -> bool:
    """Tell whether a run is finished and has what its kind has; a person may have edited it since."""
    tags, metrics = run.data.tags, _METRICS.get(run.data.tags.get(KIND, ""))
    if run.info.status != "FINISHED" or metrics is None or not _DIGEST.fullmatch(tags.get(CONFIGURATION, "")):
        return False
    said = run.data.metrics
    return all(least <= said.get(name, math.nan) <= most for name, (least, most) in metrics.items())


def keep_one(store: Store, finished: Sequence[Run | LocalRun]) -> Run | LocalRun:
    """Of the finished runs of one identity leave one, and return it: the newest that replaces, else the oldest.

    All who look agree on the one that stays, and whoever finishes last sees all of them.
    """
    stays = max(finished, key=lambda r: (r.data.tags.get(REPLACES, ""), -(r.info.start_time or 0), r.info.run_id))
    for run in finished:
        if run is not stays:
            _delete(store, run.info.run_id)
    return stays


def mark_failed(store: Store, run_id: str, reason: str) -> None:
    """Mark a run as failed that has not been finished, and say why, as far as there is room for it."""
    shown = masked(reason, store.uri)
    if len(shown) > LONGEST_TAG:
        shown = f"{shown[: LONGEST_TAG - 4]} ..."
    store.client.set_tag(run_id, REASON, shown)
    store.client.set_terminated(run_id, "FAILED")


@contextmanager
def unless_gone() -> Iterator[None]:
    """Do something with a run, unless another process or a person has deleted it."""
    from mlflow.exceptions import MlflowException

    try:
        yield
    except MlflowException as problem:
        if problem.error_code not in ("INVALID_PARAMETER_VALUE", "RESOURCE_DOES_NOT_EXIST"):
            raise


def _delete(store: Store, run_id: str) -> None:
    with unless_gone():
        store.client.delete_run(run_id)


def _now() -> str:
    return str(int(time.time() * 1000))
