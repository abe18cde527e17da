"""Stores to bring runs from and into."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from mlflow import MlflowClient

from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.runs.batch import keep_batch
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.solver import Solver


@pytest.fixture(scope="session")
def what() -> Setup:
    """Return what all trials are of."""
    return Setup.of(
        resolve("aco", {"iterations": 4, "ants": 2}),
        Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard"),
    )


@pytest.fixture(scope="session")
def seeds() -> Seeds:
    """Return the seeds of the batch."""
    return parse_seeds("0-9")


@pytest.fixture(scope="session")
def blank(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a database with MLflow's tables and nothing in them, to be copied: making them takes a second."""
    file = tmp_path_factory.mktemp("blank") / "mlflow.db"
    MlflowClient(f"sqlite:///{file}").search_experiments()
    return file


@pytest.fixture(scope="session")
def prepared(blank: Path) -> Callable[[Path], MlflowTracker]:
    """Return what makes a store in a file, ready."""

    def prepare(file: Path) -> MlflowTracker:
        file.parent.mkdir(exist_ok=True)
        shutil.copy(blank, file)
        tracker = MlflowTracker(f"sqlite:///{file}")
        tracker.prepare()
        return tracker

    return prepare


@pytest.fixture(scope="session")
def elsewhere(
    prepared: Callable[[Path], MlflowTracker],
    what: Setup,
    seeds: Seeds,
    tmp_path_factory: pytest.TempPathFactory,
) -> Path:
    """The store of another machine, with three trials, a batch and a failure; moved here with its artifacts."""
    folder = tmp_path_factory.mktemp("other")
    tracker = prepared(folder / "there" / "mlflow.db")
    for result in Solver(what.grid, what.settings).solve_many(range(3)):
        tracker.log(Trial(what, result))
    tracker.log_failure(what, 7, "the part broke")
    keep_batch(what, seeds, tracker)
    shutil.move(folder / "there", folder / "here")
    return folder / "here" / "mlflow.db"
