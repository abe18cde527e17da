"""MLflow as the store: in one experiment a run for each trial, or one for a batch with a table of its trials."""

from __future__ import annotations

import logging
import sqlite3
import tempfile
from collections.abc import Collection, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acoexp.errors import SettingsError
from acoexp.grid.grid import Grid
from acoexp.tracking.mlflow.content import batch_metrics, description, trial_metrics, versions
from acoexp.tracking.mlflow.left_behind import close_left_behind
from acoexp.tracking.mlflow.lookup import LocalRun, runs_with
from acoexp.tracking.mlflow.masking import masked
from acoexp.tracking.mlflow.moving import is_away
from acoexp.tracking.mlflow.run import (
    CONFIGURATION,
    IDENTITY,
    KIND,
    LONGEST_TAG,
    NOTE,
    RunWriter,
    is_whole,
    keep_one,
)
from acoexp.tracking.mlflow.store import EXPERIMENT, open_store
from acoexp.tracking.setup import Artifacts, Found, Setup, Trial
from acoexp.trial.outcome import Batch
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.table import csv_lines
from acoexp.trial.trials import Trials

if TYPE_CHECKING:
    from mlflow.entities import Run

log = logging.getLogger(__name__)

_LOOK_UP = 50
"""Runs that are loaded in about the time in which one of a hundred thousand is looked up."""
_FEW = 10
"""Runs that are looked up one by one, however many others there are."""
_LONGEST_NAME = 250
_FINISHED = "attributes.status = 'FINISHED'"
ARCHIVES = "trials"
"""Folder of a batch's artifacts that holds its trials with their curves, a file for each portion."""


class MlflowTracker:
    """Keeps trials in an experiment of the MLflow store at an address."""

    def __init__(self, uri: str, experiment: str = EXPERIMENT) -> None:
        self.store = open_store(uri, experiment)
        self.address = self.store.uri
        self.where = f"MLflow experiment {experiment!r} at {self.store.shown}"

    def check(self) -> None:
        """Refuse a local database that is there and cannot be written, which is seen without MLflow.

        Raises:
            TrackingError: if it is one.
        """
        self.store.check()

    def prepare(self) -> None:
        """Create the store and the experiment if they are not there; close the runs that were left behind.

        Raises:
            TrackingError: if the store cannot be reached or written.
        """
        self.store.prepare()
        self.store.with_retries(lambda: close_left_behind(self.store), "cannot be opened")

    def find(self, configuration_id: str, identities: Collection[str]) -> dict[str, Found]:
        """Return the finished runs of a configuration that are of some identities, each under its own."""
        same: dict[str, list[Run | LocalRun]] = {identity: [] for identity in identities}
        for run in filter(is_whole, self._finished(identities, configuration_id)):
            same.get(run.data.tags.get(IDENTITY, ""), []).append(run)
        return {identity: self._found(runs) for identity, runs in same.items() if runs}

    def has(self, identity: str) -> bool:
        """Tell whether there is a finished run of an identity."""
        return any(map(is_whole, self._finished([identity])))

    def has_all(self, identities: Collection[str]) -> bool:
        """Tell whether a look into a local database that was not moved shows a finished run of each identity."""
        file = self.store.file
        try:
            if file is None or is_away(file, self.store.experiment):
                return False
            runs = runs_with(file, self.store.experiment, IDENTITY, identities)
        except sqlite3.Error:  # whoever makes the store ready tells why
            return False
        return {run.data.tags[IDENTITY] for run in runs if is_whole(run)} >= {*identities}

    def find_trials(self, configuration_id: str, seeds: Seeds) -> Iterator[Trials]:
        """Yield trials of a configuration that were kept in batches, finished or not, each at most once."""
        runs = self._search(f"tags.{CONFIGURATION} = '{configuration_id}' and tags.{KIND} = 'batch'")
        wanted = seeds.array()
        batches = (run for run in runs if _may_hold(run, wanted))
        for portion in (portion for run in batches for portion in self._portions(run)):
            new = portion.among(wanted)
            if len(new):
                yield new
                wanted = np.setdiff1d(wanted, new.seeds)
            if not wanted.size:
                return

    def log(self, trial: Trial, *, resume: bool = True) -> None:
        """Keep one trial as one run, unless it is there.

        Args:
            trial: The trial.
            resume: Whether the same trial, if it is there, stays; otherwise this one takes its place.

        Raises:
            TrackingError: if the store does not take it; the run is then marked as failed.
        """
        if resume and self.has(trial.identity):
            what = f"{trial.setup.settings.label} on {trial.setup.grid.name}, seed {trial.result.seed}"
            log.info("%s: found in the store, which keeps one run of it", what)
            return
        writer = self._writer(trial.setup, "seed", trial.result.seed, resume)
        try:
            writer.begin(list(trial_metrics(trial.result, trial.seconds)))
            writer.log_files(trial.artifacts)
            writer.finish()
        except BaseException as problem:
            writer.abort(str(problem) or type(problem).__name__)
            raise

    def log_failure(self, setup: Setup, seed: int, reason: str) -> None:
        """Keep that a trial failed, and why."""
        writer = self._writer(setup, "seed", seed, resume=True)
        writer.begin()
        writer.fail(reason)

    def begin(self, setup: Setup, seeds: Seeds, *, resume: bool = True) -> BatchRun:
        """Begin to keep a batch as one run."""
        writer = self._writer(setup, "seeds", seeds, resume)
        writer.begin()
        return BatchRun(writer, setup.grid)

    def _finished(
        self, identities: Collection[str], configuration_id: str | None = None
    ) -> Sequence[Run | LocalRun]:
        """Return finished runs, those of some identities among them; of a server all of their configuration, if
        these are many and that is less work."""
        file = self.store.file
        if file is not None:
            return self.store.with_retries(
                lambda: runs_with(file, self.store.experiment, IDENTITY, identities), "cannot be searched"
            )
        if len(identities) > _FEW:
            as_quick = _LOOK_UP * len(identities)
            runs = self._search(f"tags.{CONFIGURATION} = '{configuration_id}' and {_FINISHED}", as_quick)
            if len(runs) <= as_quick:
                return runs
        of_each = (self._search(f"tags.{IDENTITY} = '{identity}' and {_FINISHED}") for identity in identities)
        return list(chain.from_iterable(of_each))

    def _search(self, condition: str, at_most: int | None = None) -> list[Run]:
        return self.store.with_retries(lambda: self.store.search(condition, at_most), "cannot be searched")

    def _found(self, runs: Sequence[Run | LocalRun]) -> Found:
        """Return the one run of an identity; a process killed right after it finished one may have left two."""
        run = self.store.with_retries(lambda: keep_one(self.store, runs), "cannot be searched")
        metrics = run.data.metrics
        return Found(run.data.tags[KIND], int(metrics.get("trials", 1)), metrics)

    def _writer(self, setup: Setup, key: str, seeds: object, resume: bool) -> RunWriter:
        name = f"{setup.settings.label} {setup.grid.name} {key} {seeds}"[:_LONGEST_NAME]
        tags = {
            "map.digest": setup.grid.digest,
            CONFIGURATION: setup.configuration_id,
            IDENTITY: setup.identity(seeds),
            KIND: "trial" if key == "seed" else "batch",
            NOTE: description(setup.settings, setup.grid, setup.command, f"{key} {seeds}")[:LONGEST_TAG],
            **versions(setup.settings.packages),
        }
        return RunWriter(self.store, name, {**setup.params, key: str(seeds)}, tags, replace=not resume)

    def _portions(self, run: Run) -> Iterator[Trials]:
        client, run_id = self.store.client, run.info.run_id
        with tempfile.TemporaryDirectory() as folder:
            artifacts = self.store.with_retries(lambda: client.list_artifacts(run_id, ARCHIVES), "cannot be read")
            if not artifacts and is_whole(run):
                place = masked(run.info.artifact_uri)
                log.warning("run %s: its trials are no longer in %s", run_id, place)
            for artifact in artifacts:

                def fetch(name: str = artifact.path) -> bytes:
                    return Path(client.download_artifacts(run_id, name, folder)).read_bytes()

                try:
                    yield Trials.from_bytes(self.store.with_retries(fetch, "cannot be read"))
                except ValueError:
                    log.warning("run %s: %s is damaged and is left out", run_id, artifact.path)


class BatchRun:
    """A batch that is being kept as a run."""

    def __init__(self, writer: RunWriter, grid: Grid) -> None:
        self._writer, self._grid, self._portions = writer, grid, 0

    def keep(self, portion: Trials) -> None:
        """Keep a portion of finished trials as an artifact."""
        self._writer.log_files({f"{self._portions:05}.npz": portion.to_bytes()}, ARCHIVES)
        self._portions += 1
        self._writer.heartbeat()

    def finish(self, batch: Batch, artifacts: Artifacts) -> None:
        """Keep the aggregates, the table, and what is carried of the best trial, and end the run."""
        failed = {failure.seed: str(failure.reason) for failure in batch.failures}
        if len(batch.table):
            self._writer.log_metrics(list(batch_metrics(batch, self._grid)))
            self._keep_table(batch)
            self._writer.log_files(artifacts)
        if not failed:
            return self._writer.finish()
        self._writer.log_text("".join(f"{seed}: {why}\n" for seed, why in failed.items()), "failed.txt")
        return self._writer.fail(f"{len(failed)} trials failed: {next(iter(failed.values()))}")

    def _keep_table(self, batch: Batch) -> None:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "trials.csv"
            with file.open("w", encoding="utf-8") as lines:
                lines.writelines(f"{line}\n" for line in csv_lines(batch.table))
            self._writer.log_file(file, None)

    def abandon(self, reason: str) -> None:
        """End the run as failed; what was kept stays."""
        self._writer.abort(reason)


def _may_hold(run: Run, wanted: NDArray[np.uint64]) -> bool:
    """Tell whether a batch may hold trials of these seeds.

    Any may whose seeds are no parameter: MLflow takes no such long one, or a person has written over it.
    """
    try:
        return bool(np.intersect1d(wanted, parse_seeds(run.data.params.get("seeds")).array()).size)
    except SettingsError:
        return True
