"""A store for all tests of this folder."""

from __future__ import annotations

import pytest

from acoexp.tracking.mlflow.tracker import MlflowTracker


@pytest.fixture(scope="session")
def store(tmp_path_factory: pytest.TempPathFactory) -> MlflowTracker:
    """Return a store that is ready, which takes a second; tests tell their trials apart by rho."""
    tracker = MlflowTracker(f"sqlite:///{tmp_path_factory.mktemp('store')}/mlflow.db")
    tracker.prepare()
    return tracker
