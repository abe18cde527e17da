"""One run in the store: written piece by piece, finished at the end, and alone of its identity then."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cache
from importlib.metadata import version
from pathlib import Path
from secrets import token_hex
from subprocess import DEVNULL, SubprocessError, check_output
from typing import TYPE_CHECKING

from acoexp.blame import packages_of
from acoexp.tracking.owner import this_process
from acoexp.tracking.setup import Setup
from acoexp.tracking.store import Store

if TYPE_CHECKING:
    from mlflow.entities import Metric

LONGEST_PARAM = 500
"""Characters of a parameter that every MLflow store keeps; a longer one goes to an artifact."""
LARGEST_BATCH = 1000
"""Metrics that MLflow takes in one call."""

IDENTITY, CELL, KIND = "identity", "cell", "kind"
"""Tags: what the run is of; which configuration on which map; ``trial`` or ``batch``."""
OWNER, WRITER, ALIVE = "owner", "writer", "alive"
"""Tags: which process writes the run, by which of its writers, and when it last did, in milliseconds."""
REASON = "reason"
"""Tag: why the run has failed."""


class RunWriter:
    """A run that is being written."""

    def __init__(
        self,
        store: Store,
        name: str,
        params: Mapping[str, str],
        tags: Mapping[str, str],
        *,
        anew: bool = False,
        started: int | None = None,
    ) -> None:
        """Begin a run.

        Args:
            store: Where.
            name: What it is called.
            params: Its configuration, flattened.
            tags: What is known of it besides; ``IDENTITY`` among it.
            anew: Whether it takes the place of a finished run of its identity.
            started: When it began, in milliseconds since 1970; now, if that is not said.
        """
        self._store, self._anew = store, anew
        self._name, self._params, self._tags = name, params, tags
        self._started = int(_now()) if started is None else started
        self._token = token_hex(8)
        self._run_id: str | None = None

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
        self.do(lambda run_id: self._store.client.log_text(run_id, text, name))

    def log_file(self, file: Path, folder: str | None) -> None:
        """Keep a file as an artifact in a folder."""
        self.do(lambda run_id: self._store.client.log_artifact(run_id, str(file), folder))

    def show_life(self) -> None:
        """Note that the process that writes this run is at work."""
        self.do(lambda run_id: self._store.client.set_tag(run_id, ALIVE, _now()))

    def finish(self, ended: int | None = None) -> None:
        """Say that the run is finished, and see to it that it is the only one of its identity."""
        self.do(lambda run_id: self._store.client.set_terminated(run_id, "FINISHED", ended))
        self.do(self._settle)

    def end(self, status: str, reason: str) -> None:
        """Say that the run will not be finished, and why."""
        self.do(lambda run_id: mark_ended(self._store, run_id, status, reason))

    def give_up(self) -> None:
        """Mark the run as failed if the store still takes that; for when there is no time to be patient."""
        if self._run_id is not None:
            with suppress(Exception):
                self._store.client.set_terminated(self._run_id, "FAILED")

    def do(self, action: Callable[[str], object]) -> None:
        """Do something with the run, given its id, again and again while the store is away."""

        def with_run() -> None:
            if self._run_id is None:
                tags = {**self._tags, OWNER: this_process(), WRITER: self._token, ALIVE: _now()}
                run = self._store.client.create_run(self._store.experiment_id, self._started, tags, self._name)
                self._run_id = run.info.run_id
            action(self._run_id)

        self._store.patiently(with_run, "does not take a trial")

    def _settle(self, run_id: str) -> None:
        """Of several finished runs of this identity, leave one.

        Whoever finishes last sees all of them, and all who look agree on the one that stays.
        """
        same = self._store.search(f"tags.{IDENTITY} = '{self._tags[IDENTITY]}'")
        finished = sorted((r.info.start_time, r.info.run_id) for r in same if r.info.status == "FINISHED")
        stays = run_id if self._anew else finished[0][1]
        for run in same:
            superfluous = run.info.status == "FINISHED" and run.info.run_id != stays
            lost_on_the_way = run.info.status == "RUNNING" and run.data.tags.get(WRITER) == self._token
            if superfluous or lost_on_the_way:
                _delete(self._store, run.info.run_id)


def mark_ended(store: Store, run_id: str, status: str, reason: str) -> None:
    """End a run that has not been finished, and say why."""
    store.client.set_tag(run_id, REASON, reason)
    store.client.set_terminated(run_id, status)


def _delete(store: Store, run_id: str) -> None:
    """Delete a run, unless another process has done so already."""
    from mlflow.exceptions import MlflowException

    try:
        store.client.delete_run(run_id)
    except MlflowException as problem:
        if problem.error_code not in ("INVALID_PARAMETER_VALUE", "RESOURCE_DOES_NOT_EXIST"):
            raise


def _now() -> str:
    return str(int(time.time() * 1000))


def tags_of(setup: Setup) -> dict[str, str]:
    """Return what is known of a setup besides its parameters, as tags."""
    tags = {"map.digest": setup.grid.digest, CELL: setup.cell, "acoexp.version": version("acoexp")}
    tags |= {f"{group}.package": package for group, package in packages_of(setup.settings).items()}
    commit = _git_commit()
    return {**tags, "mlflow.source.git.commit": commit} if commit else tags


@cache
def _git_commit() -> str | None:
    """Return the commit of the working directory, if it is in a repository."""
    try:
        return check_output(["git", "rev-parse", "HEAD"], stderr=DEVNULL, text=True, timeout=5).strip()
    except (OSError, SubprocessError):
        return None
