"""What is kept of a trial, and which tracker a configuration asks for; all without a store."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from acoexp import Grid
from acoexp.errors import SettingsError
from acoexp.result import Result
from acoexp.tracking import NoTracker, Trial, open_tracker
from acoexp.tracking.mlflow_store import MlflowTracker
from acoexp.tracking.tracker import flatten

CONFIG = {
    "algo": "pdg",
    "seed": 3,
    "rho": 0.5,
    "map": {"name": "file", "start": None, "path": "yard.txt"},
    "diffusion": {"name": "gaussian", "gamma": 0.01},
    "tracking": {"name": "mlflow", "uri": "http://user:secret@server"},
    "report": {"name": "none"},
}


def trial(obstacles: Any = ((0, 0), (0, 0)), algo: str = "pdg", **changes: Any) -> Trial:
    """Return a trial, most of whose result does not matter here."""
    curve, lost = np.array([[0, 1]], dtype=np.int32), np.zeros(1, dtype=np.int32)
    moves = np.array([7], dtype=np.uint8)
    return Trial(Result(algo, 3, Grid(obstacles), moves, None, curve, lost, 1), CONFIG | changes)


def test_a_nested_configuration_is_flattened_in_order() -> None:
    config = {"b": {"y": 1.5, "x": {"deep": None}}, "a": [1, 2]}
    assert list(flatten(config)) == [("b.y", "1.5"), ("b.x.deep", "None"), ("a", "[1, 2]")]


def test_params_are_what_the_result_depends_on() -> None:
    assert trial().params == {
        "algo": "pdg", "seed": "3", "rho": "0.5", "map.name": "file", "map.start": "None", "map.path": "yard.txt",
        "diffusion.name": "gaussian", "diffusion.gamma": "0.01",
    }  # fmt: skip


def test_a_password_in_the_stores_address_is_in_no_param() -> None:
    assert "secret" not in str(trial().params)


def test_the_algorithm_is_called_what_it_was_and_not_what_it_began_as() -> None:
    assert trial(algo="custom").params["algo"] == "custom"


@pytest.mark.parametrize("changes", [{"seed": 4}, {"tracking": {"name": "none"}}, {"report": {"name": "paper"}}])
def test_trials_that_are_averaged_share_a_cell(changes: dict[str, Any]) -> None:
    assert trial(**changes).cell == trial().cell


@pytest.mark.parametrize(
    "changes",
    [{"rho": 0.6}, {"diffusion": {"name": "none"}}, {"algo": "custom"}, {"obstacles": ((0, 1), (0, 0))}],
)
def test_trials_that_are_not_averaged_have_other_cells(changes: dict[str, Any]) -> None:
    assert trial(**changes).cell != trial().cell


def test_no_tracking_touches_nothing(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    tracker = open_tracker({"name": "none"})
    assert isinstance(tracker, NoTracker)
    tracker.prepare()
    tracker.log(trial())
    assert list(tmp_path.iterdir()) == []


def test_opening_a_store_touches_nothing_yet(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
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
