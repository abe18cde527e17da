"""Which tracker a configuration asks for; nothing is touched, and a store that would not last is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from acoexp.errors import SettingsError
from acoexp.tracking.open import check_uri, experiment_named, open_tracker


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def refusal(**config: Any) -> str:
    """Return the message with which a configuration is refused."""
    with pytest.raises(SettingsError) as caught:
        open_tracker(config)
    return str(caught.value)


@pytest.mark.parametrize(
    ("config", "address"),
    [
        ({"name": "mlflow"}, "sqlite:///{}/outputs/mlflow.db"),
        ({"name": "mlflow", "uri": "sqlite:///mine/x.db?timeout=30"}, "sqlite:///{}/mine/x.db?timeout=30"),
        ({"name": "mlflow", "uri": "http://server:5000"}, "http://server:5000"),
        ({"name": "none"}, None),
    ],
)
def test_a_tracker_has_an_address_that_holds_anywhere_and_touches_nothing_yet(
    config: dict[str, Any], address: str | None, tmp_path: Path
) -> None:
    assert open_tracker(config).address == (None if address is None else address.format(tmp_path))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("config", "said"),
    [
        ({"name": "wandb"}, "tracking: expected one of: mlflow, none; got 'wandb'"),
        ({"name": "mlflo"}, "tracking: expected one of: mlflow, none; got 'mlflo'; did you mean mlflow?"),
        ({"name": ["mlflow"]}, "tracking: expected one of: mlflow, none; got ['mlflow']"),
        ({}, "tracking: expected one of: mlflow, none; got None"),
    ],
)
def test_a_tracker_that_there_is_not_is_refused(config: dict[str, Any], said: str) -> None:
    assert refusal(**config) == said


@pytest.mark.parametrize(
    ("config", "said"),
    [
        (
            {"name": "none", "uri": "x"},
            "tracking.uri is not a known key; expected one of: none: it has no parameters",
        ),
        (
            {"name": "mlflow", "urn": "x"},
            "tracking.urn is not a known key; expected one of: tracking.uri, tracking.experiment",
        ),
        ({"name": "mlflow", "uri": 3}, "tracking.uri: expected a text; got 3"),
        ({"name": "mlflow", "uri": "???"}, "tracking.uri: expected a text; got nothing"),
        ({"name": "mlflow", "uri": None}, "tracking.uri: expected a text; got nothing"),
    ],
)
def test_its_parameters_are_checked_like_all_others(config: dict[str, Any], said: str) -> None:
    assert refusal(**config) == said


@pytest.mark.parametrize(
    "uri",
    ["", "???", "sqlite://", "sqlite:///", "sqlite:///:memory:", "sqlite:///file:x?mode=memory", "sqlite:///?x=1"],
)
def test_a_store_that_does_not_last_is_refused(uri: str) -> None:
    with pytest.raises(SettingsError, match=r"^tracking.uri: expected the address of an MLflow store that lasts"):
        check_uri(uri)


@pytest.mark.parametrize(
    "uri", ["sqlite:///x.db", "sqlite+pysqlite:///x.db", "postgresql://me@server/runs", "https://server"]
)
def test_any_store_that_lasts_will_do(uri: str) -> None:
    assert check_uri(uri) == uri


def test_an_address_that_is_refused_is_shown_without_its_password() -> None:
    said = refusal(name="mlflow", uri="sqlite://?mode=memory&password=s3cret")
    assert said.endswith("got 'sqlite://?mode=memory&password=***'")


def test_an_experiment_is_named_by_its_key_or_by_mlflows_variable(monkeypatch: pytest.MonkeyPatch) -> None:
    assert "experiment 'acoexp'" in open_tracker({"name": "mlflow"}).where
    monkeypatch.setenv("MLFLOW_EXPERIMENT_NAME", "theirs")
    assert "experiment 'theirs'" in open_tracker({"name": "mlflow"}).where
    assert "experiment 'mine'" in open_tracker({"name": "mlflow", "experiment": "mine"}).where
    monkeypatch.setenv("MLFLOW_EXPERIMENT_NAME", "")
    assert "experiment 'acoexp'" in open_tracker({"name": "mlflow", "experiment": None}).where


@pytest.mark.parametrize("name", ["", " ", " mine", "mine\n", "a\x1bb", "x" * 251, "???"])
def test_a_name_that_no_experiment_can_have_is_refused(name: str) -> None:
    with pytest.raises(SettingsError, match=r"^tracking.experiment, or MLFLOW_EXPERIMENT_NAME: "):
        experiment_named(name)
