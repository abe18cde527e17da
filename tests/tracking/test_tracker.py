"""Which tracker a configuration asks for; all without a store."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from acoexp.errors import SettingsError
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.open import open_tracker
from acoexp.tracking.tracker import NoTracker
from acoexp.trial.seeds import parse_seeds


def test_no_tracking_touches_nothing_and_finds_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    tracker = open_tracker({"name": "none"})
    assert isinstance(tracker, NoTracker)
    tracker.prepare()
    assert (tracker.find("c"), tracker.has("i"), [*tracker.find_trials("c", parse_seeds("0-9"))]) == (
        {},
        False,
        [],
    )
    assert list(tmp_path.iterdir()) == []


def test_opening_a_store_touches_nothing_yet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert isinstance(open_tracker({"name": "mlflow", "uri": "sqlite:///outputs/mlflow.db"}), MlflowTracker)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("config", "said"),
    [
        ({"name": "wandb"}, "tracking: expected one of: mlflow, none; got 'wandb'"),
        ({}, "tracking: expected one of: mlflow, none; got None"),
        ({"name": "none", "uri": "x"}, "tracking.uri is not a known key of tracking=none"),
        ({"name": "mlflow", "uri": 3}, "tracking.uri: expected the address of an MLflow store that lasts; got 3"),
        ({"name": "mlflow", "uri": "???"}, "tracking.uri: expected the address"),
        ({"name": "mlflow"}, "tracking.uri: expected the address"),
    ],
)
def test_a_tracker_that_there_is_not_is_refused(config: dict[str, Any], said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        open_tracker(config)
    assert str(caught.value).startswith(said)


@pytest.mark.parametrize("uri", ["sqlite://", "sqlite:///", "sqlite:///:memory:", "sqlite:///file:x?mode=memory"])
def test_a_store_that_does_not_last_is_refused(uri: str) -> None:
    with pytest.raises(SettingsError, match="expected the address of an MLflow store that lasts"):
        open_tracker({"name": "mlflow", "uri": uri})
