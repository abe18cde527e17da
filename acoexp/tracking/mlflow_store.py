"""MLflow as the store: experiment ``acoexp``, one run per trial, written in one batch.

mlflow takes over a second to import, so it is imported when a trial is to be kept and not before.
"""

from __future__ import annotations

import logging
import math
import os
import re
import sqlite3
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, nullcontext
from functools import cache, cached_property
from importlib.metadata import version
from pathlib import Path
from subprocess import DEVNULL, SubprocessError, check_output
from typing import TYPE_CHECKING

from filelock import FileLock

from acoexp.errors import TrackingError
from acoexp.tracking.tracker import Trial

if TYPE_CHECKING:
    from mlflow import MlflowClient
    from mlflow.entities import Metric

EXPERIMENT = "acoexp"
LONGEST_PARAM = 500
"""Characters of a parameter that every MLflow store keeps; a longer one goes to an artifact."""
LARGEST_BATCH = 1000
"""Metrics that MLflow takes in one call."""

_SQLITE = "sqlite:///"


class MlflowTracker:
    """Keeps trials in the MLflow store at an address."""

    def __init__(self, uri: str) -> None:
        file, mark, query = uri.removeprefix(_SQLITE).partition("?")
        self._file = Path(file).absolute() if uri.startswith(_SQLITE) else None
        self.uri = uri if self._file is None else f"{_SQLITE}{self._file}{mark}{query}"
        self._shown = re.sub(r"//[^/@]*@", "//***@", uri)  # no password on a screen or in a log
        self.where = f"MLflow experiment {EXPERIMENT!r} at {self._shown}"

    def prepare(self) -> None:
        """Create the store and the experiment if they are not there.

        Raises:
            TrackingError: if the store cannot be reached or written.
        """
        with self._reporting("cannot be opened"), _few_retries():
            if self._file is not None:
                self._file.parent.mkdir(parents=True, exist_ok=True)
            # several processes that migrate one fresh database at once all fail
            lock = FileLock(f"{self._file}.lock") if self._file is not None else nullcontext()
            with lock:
                if self._file is not None:
                    _check_writable(self._file)
                experiment = self._client.get_experiment_by_name(EXPERIMENT)
                if experiment is None:
                    self._client.create_experiment(EXPERIMENT, self._artifacts())
                elif experiment.lifecycle_stage != "active":
                    self._client.restore_experiment(experiment.experiment_id)

    def log(self, trial: Trial) -> None:
        """Keep one trial as one run.

        Raises:
            TrackingError: if the store does not take it; the run is then marked as failed.
        """
        from mlflow.entities import Param, RunTag

        result, params = trial.result, trial.params
        long = {key: value for key, value in params.items() if len(value) > LONGEST_PARAM}
        kept = [Param(key, value) for key, value in params.items() if key not in long]
        tags = [RunTag(key, value) for key, value in _tags(trial).items()]
        now = int(time.time() * 1000)
        metrics = list(_metrics(trial, now))
        with self._reporting("does not take a trial"):
            name = f"{result.algo} {result.grid.name} seed {result.seed}"
            run = self._client.create_run(self._experiment_id, start_time=now, run_name=name)
            try:
                self._client.log_batch(run.info.run_id, metrics[:LARGEST_BATCH], kept, tags)
                for first in range(LARGEST_BATCH, len(metrics), LARGEST_BATCH):
                    self._client.log_batch(run.info.run_id, metrics[first : first + LARGEST_BATCH])
                for key, value in long.items():
                    self._client.log_text(run.info.run_id, value, f"params/{key}.txt")
                self._client.set_terminated(run.info.run_id, "FINISHED")
            except BaseException:
                self._client.set_terminated(run.info.run_id, "FAILED")
                raise

    @cached_property
    def _client(self) -> MlflowClient:
        logging.getLogger("alembic").setLevel(logging.WARNING)
        from mlflow import MlflowClient

        logging.getLogger("mlflow").setLevel(logging.WARNING)
        return MlflowClient(self.uri)

    @cached_property
    def _experiment_id(self) -> str:
        experiment = self._client.get_experiment_by_name(EXPERIMENT)
        if experiment is None:
            raise TrackingError(f"tracking.uri: no experiment {EXPERIMENT!r} at {self._shown}")
        return str(experiment.experiment_id)

    def _artifacts(self) -> str | None:
        """Return where artifacts go: beside a local database, else wherever the server puts them."""
        if self.uri.startswith(("http:", "https:")):
            return None
        folder = self._file.parent if self._file is not None else Path("outputs").absolute()
        return (folder / "artifacts").as_uri()

    @contextmanager
    def _reporting(self, what: str) -> Iterator[None]:
        """Turn whatever MLflow, SQLAlchemy or the system raise into one error of ours."""
        try:
            yield
        except TrackingError:
            raise
        except Exception as problem:
            reason = next(iter(str(problem).strip().splitlines()), type(problem).__name__)
            raise TrackingError(
                f"tracking.uri: expected an MLflow store that can be written; {self._shown} {what}: {reason}"
            ) from problem


def _check_writable(file: Path) -> None:
    """Take SQLite's lock for writing; MLflow would try again for minutes where that fails."""
    if file.exists() and not os.access(file, os.W_OK):
        raise PermissionError(f"{file} is read-only")
    with closing(sqlite3.connect(file, timeout=10.0, isolation_level=None)) as database:
        database.execute("BEGIN IMMEDIATE")
        database.execute("ROLLBACK")


@contextmanager
def _few_retries() -> Iterator[None]:
    """Let MLflow give up within seconds on a server that is not there; by default it takes minutes."""
    key = "MLFLOW_HTTP_REQUEST_MAX_RETRIES"
    if key in os.environ:
        yield
        return
    os.environ[key] = "2"
    try:
        yield
    finally:
        del os.environ[key]


def _metrics(trial: Trial, now: int) -> Iterator[Metric]:
    from mlflow.entities import Metric

    result = trial.result
    values: dict[str, float] = {
        "x1": result.x1,
        "x2": result.x2,
        "x3": result.x3,
        "l1": result.l1,
        "l2": result.l2,
        "optimum": result.optimum,
        "lost_ants": float(result.lost_ants.sum()),
    }
    undefined = {key for key in ("x1", "x2", "x3") if values[key] == 0}
    undefined |= {key for key, value in values.items() if math.isnan(value)}
    for key, value in values.items():
        if key not in undefined:
            yield Metric(key, value, now, 0)
    for cycle, length in enumerate(result.curve.tolist(), 1):
        if not math.isnan(length):
            yield Metric("best_length", length, now, cycle)


def _tags(trial: Trial) -> dict[str, str]:
    tags = {
        "map.digest": trial.result.grid.digest,
        "cell": trial.cell,
        "acoexp.version": version("acoexp"),
    }
    commit = _git_commit()
    return {**tags, "mlflow.source.git.commit": commit} if commit else tags


@cache
def _git_commit() -> str | None:
    """Return the commit of the working directory, if it is in a repository."""
    try:
        return check_output(["git", "rev-parse", "HEAD"], stderr=DEVNULL, text=True, timeout=5).strip()
    except (OSError, SubprocessError):
        return None
