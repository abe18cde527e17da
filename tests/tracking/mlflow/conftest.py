"""Stores on this machine: making one takes a second, a copy of a blank one none."""

from __future__ import annotations

import shutil
from itertools import count
from pathlib import Path

import pytest
from mlflow import MlflowClient

from acoexp.tracking.mlflow import store as store_module
from acoexp.tracking.mlflow.store import Store
from acoexp.tracking.mlflow.tracker import MlflowTracker

IDENTITIES = map("identity {}".format, count())


@pytest.fixture(scope="session")
def blank(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a database with MLflow's tables and nothing in them."""
    file = tmp_path_factory.mktemp("blank") / "mlflow.db"
    MlflowClient(f"sqlite:///{file}").search_experiments()
    return file


@pytest.fixture
def fresh(blank: Path, tmp_path: Path) -> str:
    """Return the address of a store that has not been prepared."""
    shutil.copy(blank, tmp_path / "fresh.db")
    return f"sqlite:///{tmp_path}/fresh.db"


@pytest.fixture(scope="session")
def tracker(blank: Path, tmp_path_factory: pytest.TempPathFactory) -> MlflowTracker:
    """Return a tracker whose store is ready; tests tell their trials apart by rho or by an identity."""
    file = tmp_path_factory.mktemp("store") / "mlflow.db"
    shutil.copy(blank, file)
    tracker = MlflowTracker(f"sqlite:///{file}")
    tracker.prepare()
    return tracker


@pytest.fixture
def store(tracker: MlflowTracker) -> Store:
    """Return a store that is ready."""
    return tracker.store


@pytest.fixture
def identity() -> str:
    """Return an identity that no other test has."""
    return next(IDENTITIES)


@pytest.fixture
def pauses(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return the pauses that were made between tries; nobody waits for them."""
    made: list[float] = []
    monkeypatch.setattr(store_module.time, "sleep", made.append)
    return made
