"""MLflow as the store: experiment ``acoexp``, one run per trial, or one per batch with a table of its trials."""

from __future__ import annotations

import logging
import tempfile
import time
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from acoexp.tracking.mlflow.content import batch_metrics, tags_of, trial_metrics
from acoexp.tracking.mlflow.owner import is_dead
from acoexp.tracking.mlflow.run import (
    ALIVE,
    CONFIGURATION,
    IDENTITY,
    KIND,
    OWNER,
    RunWriter,
    keep_one,
    mark_failed,
)
from acoexp.tracking.mlflow.store import EXPERIMENT, open_store
from acoexp.tracking.setup import Found, Setup, Trial
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.table import Aggregates
from acoexp.trial.trials import Trials

if TYPE_CHECKING:
    from mlflow.entities import Run

log = logging.getLogger(__name__)

SILENT_FOR = 600.0
"""Seconds without a sign of life after which a run that another machine began is taken for left behind."""
_LONGEST_NAME = 250
ARCHIVES = "trials"
"""Folder of a batch's artifacts that holds its trials with their curves, a file for each portion."""


class MlflowTracker:
    """Keeps trials in the MLflow store at an address."""

    def __init__(self, uri: str) -> None:
        self.store = open_store(uri)
        self.address = self.store.uri
        self.where = f"MLflow experiment {EXPERIMENT!r} at {self.store.shown}"

    def prepare(self) -> None:
        """Create the store and the experiment if they are not there; close the runs that were left behind.

        Raises:
            TrackingError: if the store cannot be reached or written.
        """
        self.store.prepare()
        self.store.with_retries(self._close_left_behind, "cannot be opened")

    def find(self, configuration_id: str) -> dict[str, Found]:
        """Return the finished runs of a configuration, each under its identity."""
        condition = f"tags.{CONFIGURATION} = '{configuration_id}' and attributes.status = 'FINISHED'"
        runs = self.store.with_retries(lambda: self.store.search(condition), "cannot be searched")
        same: dict[str, list[Run]] = {}
        for run in runs:
            same.setdefault(run.data.tags.get(IDENTITY, run.info.run_id), []).append(run)
        # a process that was killed right after it finished a run may have left two
        return {
            identity: _found(runs[0] if len(runs) == 1 else keep_one(self.store, runs))
            for identity, runs in same.items()
        }

    def has(self, identity: str) -> bool:
        """Tell whether there is a finished run of an identity."""
        condition = f"tags.{IDENTITY} = '{identity}' and attributes.status = 'FINISHED'"
        return bool(self.store.with_retries(lambda: self.store.search(condition), "cannot be searched"))

    def find_trials(self, configuration_id: str, seeds: Seeds) -> Iterator[Trials]:
        """Yield trials of a configuration that were kept in batches, finished or not, each at most once."""
        runs = self.store.with_retries(
            lambda: self.store.search(f"tags.{CONFIGURATION} = '{configuration_id}'"), "cannot be searched"
        )
        wanted = seeds.array()
        batches = (run for run in runs if run.data.tags.get(KIND) == "batch" and _may_hold(run, wanted))
        for portion in (portion for run in batches for portion in self._portions(run.info.run_id)):
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
            return
        writer = self._writer(trial.setup, "seed", trial.result.seed, resume)
        try:
            writer.begin(list(trial_metrics(trial.result)))
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
        return BatchRun(writer, setup.grid.optimum)

    def _writer(self, setup: Setup, key: str, seeds: object, resume: bool) -> RunWriter:
        name = f"{setup.settings.label} {setup.grid.name} {key} {seeds}"[:_LONGEST_NAME]
        tags = {**tags_of(setup), IDENTITY: setup.identity(seeds), KIND: "trial" if key == "seed" else "batch"}
        return RunWriter(self.store, name, {**setup.params, key: str(seeds)}, tags, replace=not resume)

    def _portions(self, run_id: str) -> Iterator[Trials]:
        client = self.store.client
        with tempfile.TemporaryDirectory() as folder:
            for artifact in self.store.with_retries(
                lambda: client.list_artifacts(run_id, ARCHIVES), "cannot be read"
            ):

                def fetch(name: str = artifact.path) -> bytes:
                    return Path(client.download_artifacts(run_id, name, folder)).read_bytes()

                try:
                    yield Trials.from_bytes(self.store.with_retries(fetch, "cannot be read"))
                except ValueError:
                    log.warning("run %s: %s is damaged and is left out", run_id, artifact.path)

    def _close_left_behind(self) -> None:
        """Mark runs as failed that no process writes any more."""
        for run in self.store.search("attributes.status = 'RUNNING'"):
            tags = run.data.tags
            if OWNER not in tags:
                continue
            dead = is_dead(tags[OWNER])
            silent = time.time() - float(tags.get(ALIVE, run.info.start_time)) / 1000.0 > SILENT_FOR
            ended = dead or (dead is None and silent)
            if ended and self.store.client.get_run(run.info.run_id).info.status == "RUNNING":
                mark_failed(self.store, run.info.run_id, "left behind by a process that was killed")


class BatchRun:
    """A batch that is being kept as a run."""

    def __init__(self, writer: RunWriter, optimum: float) -> None:
        self._writer, self._optimum, self._portions = writer, optimum, 0

    def keep(self, portion: Trials) -> None:
        """Keep a portion of finished trials as an artifact."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / f"{self._portions:05}.npz"
            file.write_bytes(portion.to_bytes())
            self._writer.log_file(file, ARCHIVES)
        self._portions += 1
        self._writer.heartbeat()

    def finish(
        self,
        summary: Aggregates | None,
        curve: NDArray[np.float64],
        table: Iterable[str],
        failed: Mapping[int, str],
    ) -> None:
        """Keep the aggregates and the table, and end the run."""
        if summary is not None:
            self._keep_table(summary, curve, table, failed)
        if not failed:
            return self._writer.finish()
        self._writer.log_text("".join(f"{seed}: {why}\n" for seed, why in failed.items()), "failed.txt")
        return self._writer.fail(f"{len(failed)} trials failed: {next(iter(failed.values()))}")

    def _keep_table(
        self, summary: Aggregates, curve: NDArray[np.float64], table: Iterable[str], failed: Mapping[int, str]
    ) -> None:
        self._writer.log_metrics(list(batch_metrics(summary, curve, len(failed), self._optimum)))
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "trials.csv"
            with file.open("w", encoding="utf-8") as lines:
                lines.writelines(f"{line}\n" for line in table)
            self._writer.log_file(file, None)

    def abandon(self, reason: str) -> None:
        """End the run as failed; what was kept stays."""
        self._writer.abort(reason)


def _may_hold(run: Run, wanted: NDArray[np.uint64]) -> bool:
    """Tell whether a batch may hold trials of these seeds; a list of seeds too long for a parameter may."""
    seeds = run.data.params.get("seeds")
    return seeds is None or bool(np.intersect1d(wanted, parse_seeds(seeds).array()).size)


def _found(run: Run) -> Found:
    metrics = run.data.metrics
    return Found(int(metrics.get("trials", 1)), metrics, run.data.params)
