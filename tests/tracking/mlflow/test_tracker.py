"""A trial in an MLflow store on this machine: whole, or marked as failed; whoever creates the store."""

from __future__ import annotations

import dataclasses
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mlflow import MlflowClient
from mlflow.entities import Run
from running import environment

from acoexp import solve
from acoexp.errors import TrackingError
from acoexp.registry.resolve import resolve
from acoexp.tracking.mlflow.tracker import MlflowTracker, _git_commit
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.result import Result

CONFIG = {"algo": "aco", "seed": 0, "map": {"name": "fig13", "path": "yard.txt"}}


@pytest.fixture(scope="module")
def uri(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return the address of a store that is ready; making one takes a second."""
    uri = f"sqlite:///{tmp_path_factory.mktemp('store')}/deeper/mlflow.db"
    MlflowTracker(uri).prepare()
    return uri


@pytest.fixture(scope="module")
def result() -> Result:
    """Return the result of a short trial."""
    return solve("fig13", algo="aco", seed=0, iterations=5, ants=4)


def runs_in(uri: str) -> list[Run]:
    """Return all runs in a store, the latest first."""
    client = MlflowClient(uri)
    experiment = client.get_experiment_by_name("acoexp")
    return list(client.search_runs([experiment.experiment_id]))


def trial(result: Result, **config: Any) -> Trial:
    """Return a trial that came from ``CONFIG``, but for what is said."""
    return Trial(Setup(resolve("aco", {}), result.grid, CONFIG | config), result)


def log(uri: str, result: Result, **config: Any) -> Run:
    """Log a trial, whether it is there or not, and return its run."""
    before = {run.info.run_id for run in runs_in(uri)}
    MlflowTracker(uri).log(trial(result, **config), resume=False)
    (run,) = (run for run in runs_in(uri) if run.info.run_id not in before)
    return run


def curve_of(uri: str, run: Run) -> dict[int, float]:
    """Return a run's curve by cycle."""
    history = MlflowClient(uri).get_metric_history(run.info.run_id, "best_length")
    assert len(history) == len({point.step for point in history})
    return {point.step: point.value for point in history}


def test_a_trial_is_one_finished_run(uri: str, result: Result) -> None:
    run = log(uri, result)
    assert run.info.status == "FINISHED"
    assert run.info.run_name == "aco fig13 seed 0"
    assert run.data.params == {"algo": "aco", "seed": "0", "map.name": "fig13", "map.path": "yard.txt"}
    assert run.data.metrics["optimum"] == result.optimum
    assert run.data.metrics["lost_ants"] == result.lost_ants.sum()
    assert run.data.tags["map.digest"] == result.grid.digest


def test_cycles_in_which_all_ants_were_lost_have_no_point(uri: str, result: Result) -> None:
    pairs = np.array([[-1, -1], [28, 8], [-1, -1], [30, 6], [-1, -1]], dtype=np.int32)
    run = log(uri, dataclasses.replace(result, curve_pairs=pairs))
    assert set(curve_of(uri, run)) == {2, 4}
    assert not {"l2", "x3"} & set(run.data.metrics)
    assert {"l1", "x1", "x2"} <= set(run.data.metrics)


def test_where_no_ant_ever_arrived_there_are_no_features(uri: str, result: Result) -> None:
    nothing = dataclasses.replace(result, curve_pairs=np.full((5, 2), -1, dtype=np.int32), moves=None)
    run = log(uri, nothing)
    assert run.info.status == "FINISHED"
    assert set(run.data.metrics) == {"optimum", "lost_ants"}


def test_more_points_than_mlflow_takes_at_once_all_arrive(uri: str, result: Result) -> None:
    pairs = np.stack([np.full(2345, 20), np.arange(2345)], axis=1).astype(np.int32)
    longer = dataclasses.replace(result, curve_pairs=pairs)
    assert curve_of(uri, log(uri, longer)) == dict(enumerate(longer.curve.tolist(), 1))


@pytest.mark.parametrize(("characters", "kept_as_param"), [(500, True), (501, False), (9000, False)])
def test_a_param_too_long_for_mlflow_becomes_an_artifact(
    uri: str, result: Result, characters: int, kept_as_param: bool, tmp_path: Path
) -> None:
    text = "ä" + "x" * (characters - 1)
    run = log(uri, result, map={"name": "file", "path": text})
    assert run.info.status == "FINISHED"
    assert run.data.params["map.name"] == "file"
    if kept_as_param:
        assert run.data.params["map.path"] == text
    else:
        assert "map.path" not in run.data.params
        file = MlflowClient(uri).download_artifacts(run.info.run_id, "params/map.path.txt", str(tmp_path))
        assert Path(file).read_text(encoding="utf-8") == text


def test_artifacts_lie_beside_the_store(uri: str) -> None:
    experiment = MlflowClient(uri).get_experiment_by_name("acoexp")
    folder = Path(uri.removeprefix("sqlite:///")).parent
    assert experiment.artifact_location == (folder / "artifacts").as_uri()


@pytest.mark.parametrize("failure", [RuntimeError("disk full\nand more"), KeyboardInterrupt()])
def test_a_run_that_cannot_be_kept_whole_is_marked_as_failed(
    uri: str, result: Result, failure: BaseException, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise failure

    before = {run.info.run_id for run in runs_in(uri)}
    monkeypatch.setattr(MlflowClient, "log_batch", fail)
    with pytest.raises((TrackingError, KeyboardInterrupt)) as caught:
        MlflowTracker(uri).log(trial(result), resume=False)
    (run,) = (run for run in runs_in(uri) if run.info.run_id not in before)
    assert run.info.status == "FAILED"
    if isinstance(caught.value, TrackingError):
        assert str(caught.value).endswith("does not take a trial: disk full")


def test_a_store_that_was_never_prepared_takes_no_trial(result: Result, tmp_path: Path) -> None:
    with pytest.raises(TrackingError, match=r"no experiment 'acoexp' at sqlite"):
        MlflowTracker(f"sqlite:///{tmp_path}/x.db").log(trial(result))


def test_preparing_twice_changes_nothing(uri: str) -> None:
    MlflowTracker(uri).prepare()
    assert sorted(e.name for e in MlflowClient(uri).search_experiments()) == ["Default", "acoexp"]


def test_four_processes_may_create_a_store_at_once(tmp_path: Path) -> None:
    code = (
        "from acoexp.tracking.mlflow.tracker import MlflowTracker; MlflowTracker('sqlite:///fresh/x.db').prepare()"
    )
    processes = [
        subprocess.Popen([sys.executable, "-c", code], cwd=tmp_path, env=environment(), stderr=subprocess.PIPE)
        for _ in range(4)
    ]
    said = [process.communicate(timeout=90.0)[1] for process in processes]
    assert [process.returncode for process in processes] == [0] * 4, said
    assert (
        len(MlflowClient(f"sqlite:///{tmp_path}/fresh/x.db").search_experiments(filter_string="name='acoexp'"))
        == 1
    )


@pytest.mark.parametrize("address", ["sqlite:///{}/my results.db", "sqlite:///{}/x.db?timeout=30"])
def test_any_address_of_sqlite_works(address: str, result: Result, tmp_path: Path) -> None:
    uri = address.format(tmp_path)
    MlflowTracker(uri).prepare()
    MlflowTracker(uri).log(trial(result), resume=False)
    assert [run.info.status for run in runs_in(uri)] == ["FINISHED"]


def test_a_store_that_became_read_only_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tracker = MlflowTracker(f"sqlite:///{tmp_path}/x.db")
    tracker.prepare()
    monkeypatch.setattr("os.access", lambda *_: False)  # a superuser may write even to what is read-only
    with pytest.raises(TrackingError, match=r"tracking.uri: expected an MLflow store that can be written.*x\.db"):
        tracker.prepare()


def test_the_commit_of_a_working_directory_in_a_repository_is_a_tag(
    uri: str, result: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def git(*args: str) -> str:
        command = ["git", "-c", "user.name=x", "-c", "user.email=x@x", *args]
        return subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True).stdout.strip()

    git("init", "-q")
    git("commit", "-q", "--allow-empty", "-m", "x")
    monkeypatch.chdir(tmp_path)
    _git_commit.cache_clear()
    try:
        assert log(uri, result).data.tags["mlflow.source.git.commit"] == git("rev-parse", "HEAD")
    finally:
        _git_commit.cache_clear()


def test_a_folder_is_no_store_and_that_is_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(TrackingError, match="unable to open database file"):
        MlflowTracker(f"sqlite:///{tmp_path}").prepare()


def test_an_experiment_that_was_deleted_in_the_ui_is_brought_back(result: Result, tmp_path: Path) -> None:
    uri = f"sqlite:///{tmp_path}/mlflow.db"
    MlflowTracker(uri).prepare()
    client = MlflowClient(uri)
    client.delete_experiment(client.get_experiment_by_name("acoexp").experiment_id)
    MlflowTracker(uri).prepare()
    assert log(uri, result).info.status == "FINISHED"


def test_a_password_is_not_shown() -> None:
    assert "secret" not in MlflowTracker("http://me:secret@server:5000").where
