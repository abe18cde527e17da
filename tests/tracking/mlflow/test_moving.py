"""Artifacts of a store that was moved or copied: found beside its database, and written there from then on."""

from __future__ import annotations

import logging
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from mlflow import MlflowClient

from acoexp.tracking.mlflow.moving import is_away
from acoexp.tracking.mlflow.run import RunWriter
from acoexp.tracking.mlflow.store import EXPERIMENT, Store


@pytest.fixture
def home(blank: Path, tmp_path: Path) -> Path:
    """Return the folder of a store with one run, ``first``, that has an artifact."""
    home = tmp_path / "a project" / "outputs"
    home.mkdir(parents=True)
    shutil.copy(blank, home / "mlflow.db")
    keep(opened(home), "first")
    return home


def opened(home: Path) -> Store:
    """Return the store in a folder, ready, as a new command opens it."""
    store = Store(f"sqlite:///{home}/mlflow.db")
    store.prepare()
    return store


def keep(store: Store, name: str) -> None:
    """Keep a run with an artifact that says its name."""
    run = RunWriter(store, name, {}, {"identity": name, "kind": "batch"})
    run.log_text(name, "said.txt")
    run.finish()


def said(uri: str) -> dict[str, str]:
    """Return what the artifacts of all runs say, by the run's name, as MLflow alone shows them."""
    client = MlflowClient(uri)
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    return {
        str(run.info.run_name): Path(client.download_artifacts(run.info.run_id, "said.txt")).read_text("utf-8")
        for run in runs
    }


def artifacts(home: Path) -> int:
    """Return how many artifacts lie beside a store."""
    return len(list((home / "artifacts").rglob("said.txt")))


def location(store: Store) -> str:
    """Return where new artifacts of a store go."""
    return str(store.client.get_experiment_by_name("acoexp").artifact_location)


def moved(home: Path, to: Path) -> None:
    home.parent.rename(to.parent)


def copied(home: Path, to: Path) -> None:
    shutil.copytree(home.parent, to.parent)


@pytest.mark.parametrize("away", [moved, copied])
def test_that_it_went_away_is_seen_until_it_is_made_ready(
    home: Path, tmp_path: Path, away: Callable[[Path, Path], None]
) -> None:
    there = tmp_path / "elsewhere" / "outputs"
    there.parent.parent.mkdir(exist_ok=True)
    assert not is_away(home / "mlflow.db", EXPERIMENT)
    away(home, there)
    assert is_away(there / "mlflow.db", EXPERIMENT)
    opened(there)
    assert not is_away(there / "mlflow.db", EXPERIMENT)


@pytest.mark.parametrize("away", [moved, copied])
def test_wherever_it_goes_its_artifacts_are_found_there_and_new_ones_are_kept_there(
    home: Path, tmp_path: Path, away: Callable[[Path, Path], None]
) -> None:
    there = tmp_path / "elsewhere, 100%" / "outputs"
    away(home, there)
    for number in (2, 3):
        keep(opened(there), f"run {number}")
        assert artifacts(there) == number
    assert said(f"sqlite:///{there}/mlflow.db") == {"first": "first", "run 2": "run 2", "run 3": "run 3"}
    assert artifacts(home) == (1 if away is copied else 0)


def test_the_original_of_a_copy_goes_on_as_it_was(home: Path, tmp_path: Path) -> None:
    there = tmp_path / "copy" / "outputs"
    copied(home, there)
    keep(opened(there), "in the copy")
    keep(opened(home), "in the original")
    assert said(f"sqlite:///{home}/mlflow.db") == {"first": "first", "in the original": "in the original"}


def test_a_copy_without_artifacts_keeps_new_ones_in_its_own_place(home: Path, tmp_path: Path) -> None:
    shutil.rmtree(home / "artifacts")
    there = tmp_path / "copy" / "outputs"
    copied(home, there)
    keep(opened(there), "new")
    assert (artifacts(home), artifacts(there)) == (0, 1)


def test_it_is_told_once_that_a_store_was_moved(
    home: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.WARNING)
    opened(home)
    assert caplog.messages == []
    there = tmp_path / "new" / "outputs"
    moved(home, there)
    for _ in range(2):
        opened(there)
    assert caplog.messages == [
        f"{there}/mlflow.db was moved or copied: its artifacts are now those in {there}/artifacts"
    ]


def test_a_store_that_was_moved_without_its_artifacts_finds_them_where_they_are(
    home: Path, tmp_path: Path
) -> None:
    (tmp_path / "new").mkdir()
    (home / "mlflow.db").rename(tmp_path / "new" / "mlflow.db")
    opened(tmp_path / "new")
    assert said(f"sqlite:///{tmp_path}/new/mlflow.db") == {"first": "first"}


def test_a_store_that_was_moved_out_of_a_folder_that_stays_finds_them(home: Path, tmp_path: Path) -> None:
    (tmp_path / "new").mkdir()
    for each in list(home.iterdir()):
        each.rename(tmp_path / "new" / each.name)
    opened(tmp_path / "new")
    assert said(f"sqlite:///{tmp_path}/new/mlflow.db") == {"first": "first"}


def test_a_store_that_is_reached_through_a_link_was_not_moved(home: Path, tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to(home.parent)
    before = location(opened(home))
    assert location(opened(tmp_path / "link" / "outputs")) == before


@pytest.mark.parametrize("chosen", ["{}/chosen", "{}/artifacts", "{}/runs/artifacts", "s3://bucket/artifacts"])
def test_a_place_that_was_chosen_for_artifacts_stays(blank: Path, tmp_path: Path, chosen: str) -> None:
    home, place = tmp_path / "home" / "outputs", chosen.format(tmp_path)
    home.mkdir(parents=True)
    if place.endswith("runs/artifacts"):
        (tmp_path / "runs" / "artifacts").mkdir(parents=True)
    shutil.copy(blank, home / "mlflow.db")
    MlflowClient(f"sqlite:///{home}/mlflow.db").create_experiment("acoexp", place)
    assert location(opened(home)) == place


def test_runs_of_other_experiments_stay_where_they_are(home: Path, tmp_path: Path) -> None:
    client = MlflowClient(f"sqlite:///{home}/mlflow.db")
    other = client.create_experiment("other", (home / "artifacts").as_uri())
    run = client.create_run(other)
    there = tmp_path / "new" / "outputs"
    moved(home, there)
    stayed = opened(there).client.get_run(run.info.run_id)
    assert stayed.info.artifact_uri == run.info.artifact_uri
