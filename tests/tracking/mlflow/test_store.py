"""An MLflow store at an address: made ready whatever its state, and asked again while it is away."""

from __future__ import annotations

import os
import re
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from forked import forking
from mlflow import MlflowClient
from mlflow.exceptions import MlflowException
from mlflow.protos.databricks_pb2 import RESOURCE_DOES_NOT_EXIST, TEMPORARILY_UNAVAILABLE
from requests.exceptions import ReadTimeout
from sqlalchemy.exc import IntegrityError, OperationalError

from acoexp.errors import StoreGoneError, TrackingError
from acoexp.tracking.mlflow import store as store_module
from acoexp.tracking.mlflow.store import Store, open_store
from acoexp.tracking.mlflow.tracker import MlflowTracker

RETRIES = "MLFLOW_HTTP_REQUEST_MAX_RETRIES"


class Failing:
    """An action that fails so many times before it is done."""

    def __init__(self, *problems: Exception) -> None:
        self.problems, self.tries = list(problems), 0

    def __call__(self) -> str:
        self.tries += 1
        if self.problems:
            raise self.problems.pop(0)
        return "done"


def experiments_of(uri: str) -> list[str]:
    """Return the names of a store's experiments."""
    return sorted(experiment.name for experiment in MlflowClient(uri).search_experiments())


# --- its address


def test_a_relative_address_is_made_absolute(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    store = Store("sqlite:///outputs/x.db?timeout=30")
    assert store.uri == f"sqlite:///{tmp_path}/outputs/x.db?timeout=30"
    assert (store.file, store.folder) == (tmp_path / "outputs" / "x.db", tmp_path / "outputs")


def test_a_server_has_no_file() -> None:
    store = Store("http://server:5000")
    assert (store.uri, store.file, store.folder) == ("http://server:5000", None, None)


@pytest.mark.parametrize("uri", ["http://me:secret@server:5000", "postgresql://me:secret@server/runs"])
def test_a_password_is_not_shown(uri: str) -> None:
    assert Store(uri).shown == re.sub("me:secret", "***", uri)
    assert "secret" not in MlflowTracker(uri).where


def test_all_who_ask_for_one_address_share_a_store_until_it_means_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    first = open_store("sqlite:///x.db")
    assert open_store("sqlite:///x.db") is first
    (tmp_path / "below").mkdir()
    monkeypatch.chdir(tmp_path / "below")
    assert open_store("sqlite:///x.db").file == tmp_path / "below" / "x.db"


# --- a quick look


def test_a_database_that_can_be_written_or_made_passes_and_so_does_a_store_elsewhere(tmp_path: Path) -> None:
    store = Store(f"sqlite:///{tmp_path}/below/x.db")
    store.check()
    assert [*tmp_path.rglob("*")] == [tmp_path / "below"]
    store.prepare()
    store.check()
    Store("nope://there").check()


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (Path.mkdir, "is a folder"),
        (os.mkfifo, "is no file"),
        (lambda file: file.write_text("no database of SQLite's\n" * 100), "not a database"),
    ],
)
def test_what_is_no_database_is_refused_and_stays(
    make: Callable[[Path], object], said: str, tmp_path: Path
) -> None:
    make(tmp_path / "x.db")
    with pytest.raises(TrackingError, match=f"expected an MLflow store that can be written; .*{said}"):
        Store(f"sqlite:///{tmp_path}/x.db").check()
    assert [*tmp_path.iterdir()] == [tmp_path / "x.db"]


# --- making it ready


def test_artifacts_lie_beside_the_store(fresh: str, tmp_path: Path) -> None:
    Store(fresh).prepare()
    experiment = MlflowClient(fresh).get_experiment_by_name("acoexp")
    assert experiment.artifact_location == (tmp_path / "artifacts").as_uri()


def test_preparing_twice_changes_nothing(fresh: str) -> None:
    for _ in range(2):
        Store(fresh).prepare()
        assert experiments_of(fresh) == ["Default", "acoexp"]


def test_a_store_is_made_with_the_folder_that_it_lies_in(tmp_path: Path) -> None:
    uri = f"sqlite:///{tmp_path}/deeper/my results.db"
    Store(uri).prepare()
    assert experiments_of(uri) == ["Default", "acoexp"]


def test_an_address_may_have_options(fresh: str) -> None:
    Store(f"{fresh}?timeout=30").prepare()
    assert experiments_of(fresh) == ["Default", "acoexp"]


def test_an_experiment_that_was_deleted_in_the_ui_is_brought_back(fresh: str) -> None:
    store = Store(fresh)
    store.prepare()
    store.client.delete_experiment(store.experiment_id)
    store.prepare()
    assert store.client.get_experiment(store.experiment_id).lifecycle_stage == "active"


def test_a_store_that_was_never_prepared_has_no_experiment(fresh: str) -> None:
    with pytest.raises(TrackingError, match=r"no experiment 'acoexp' at sqlite"):
        Store(fresh).search("")


def test_a_store_that_became_read_only_is_refused(fresh: str, monkeypatch: pytest.MonkeyPatch) -> None:
    store = Store(fresh)
    store.prepare()
    monkeypatch.setattr("os.access", lambda *_: False)  # a superuser may write even to what is read-only
    with pytest.raises(TrackingError, match=r"expected an MLflow store that can be written.*fresh\.db"):
        store.prepare()


def test_a_folder_is_no_store_and_that_is_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(TrackingError, match="is a folder"):
        Store(f"sqlite:///{tmp_path}").prepare()


def test_eight_processes_may_create_a_store_at_once(tmp_path: Path) -> None:
    context, uri = forking(), f"sqlite:///{tmp_path}/new/x.db"
    processes = [context.Process(target=Store(uri).prepare) for _ in range(8)]
    for process in processes:
        process.start()
    for process in processes:
        process.join(timeout=90.0)
    assert [process.exitcode for process in processes] == [0] * 8
    assert experiments_of(uri) == ["Default", "acoexp"]


# --- asking it


def test_runs_are_found_on_all_pages_the_oldest_first(fresh: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store_module, "_PAGE", 2)
    store = Store(fresh)
    store.prepare()
    for began in (30, 10, 50, 20, 40):
        store.client.create_run(store.experiment_id, began)
    assert [run.info.start_time for run in store.search("")] == [10, 20, 30, 40, 50]
    assert store.search("attributes.status = 'FINISHED'") == []


def test_a_run_without_a_start_at_which_mlflow_fails_is_passed_over(fresh: str) -> None:
    store = Store(fresh)
    store.prepare()
    runs = [store.client.create_run(store.experiment_id, began).info.run_id for began in (10, 20)]
    with closing(sqlite3.connect(str(store.file))) as database, database:
        database.execute("UPDATE runs SET start_time = NULL WHERE run_uuid = ?", (runs[0],))
    for condition in ("", "attributes.status = 'RUNNING'"):
        assert [run.info.run_id for run in store.search(condition)] == runs[1:]


def test_what_fails_while_the_store_is_away_is_done_when_it_is_back(
    pauses: list[float], caplog: pytest.LogCaptureFixture
) -> None:
    action = Failing(ConnectionError("no route"), ConnectionError("no route"), TimeoutError())
    assert Store("http://server").with_retries(action, "does not take a trial") == "done"
    assert pauses == [0.1, 0.2, 0.4]
    assert caplog.messages == ["http://server does not take a trial; trying again for 90 s"]


def test_pauses_never_become_long(pauses: list[float]) -> None:
    Store("http://server").with_retries(Failing(*[ConnectionError("no route")] * 9), "is away")
    assert max(pauses) == 5.0


@pytest.mark.parametrize(
    "problem",
    [
        ConnectionError("reset"),
        ReadTimeout("read"),
        OperationalError("SELECT", {}, Exception("database is locked")),
        MlflowException("restarting", TEMPORARILY_UNAVAILABLE),
    ],
    ids=lambda problem: type(problem).__name__,
)
def test_what_may_pass_is_waited_for(problem: Exception, pauses: list[float]) -> None:
    assert Store("http://server").with_retries(Failing(problem), "is away") == "done"


@pytest.mark.parametrize(
    "problem",
    [
        ValueError("odd\nand more"),
        PermissionError(13, "odd"),
        IntegrityError("INSERT", {}, Exception("odd")),
        MlflowException("odd", RESOURCE_DOES_NOT_EXIST),
    ],
    ids=lambda problem: type(problem).__name__,
)
def test_what_will_not_pass_is_told_at_once_and_in_one_line(problem: Exception, pauses: list[float]) -> None:
    action = Failing(problem)
    with pytest.raises(
        TrackingError, match=r"^tracking.uri: expected .* written; http://server is away: "
    ) as caught:
        Store("http://server").with_retries(action, "is away")
    assert "odd" in str(caught.value)
    assert "\n" not in str(caught.value)
    assert (action.tries, pauses) == (1, [])


def test_a_store_that_takes_nothing_any_more_is_not_waited_for(pauses: list[float]) -> None:
    full = OperationalError("INSERT", {}, Exception("database or disk is full"))
    with pytest.raises(StoreGoneError, match=r"^tracking.uri: http://server does not .* is full; make room there"):
        Store("http://server").with_retries(Failing(full), "does not take a trial")
    assert pauses == []


def test_a_store_that_stays_away_is_waited_for_once(pauses: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(store_module, "PATIENCE", 0.05)  # less than the first pause
    store, action = Store("http://server"), Failing(*[ConnectionError("no route")] * 3)
    with pytest.raises(StoreGoneError, match=r"http://server cannot be read for 0 s: no route"):
        store.with_retries(action, "cannot be read")
    monkeypatch.setattr(store_module, "PATIENCE", 90.0)
    with pytest.raises(TrackingError, match="no route"):
        store.with_retries(action, "cannot be read")
    assert (action.tries, pauses) == (2, [])


def test_a_store_that_was_gone_is_waited_for_again_once_it_was_made_ready(
    fresh: str, pauses: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store(fresh)
    with monkeypatch.context() as impatient:
        impatient.setattr(store_module, "PATIENCE", 0.0)
        with pytest.raises(StoreGoneError):
            store.with_retries(Failing(ConnectionError()), "is away")
    store.prepare()
    assert store.with_retries(Failing(ConnectionError()), "is away") == "done"


def test_mlflow_itself_gives_up_soon_unless_a_user_says_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    for own, tries in ((None, "2"), ("7", "7")):
        monkeypatch.setenv(RETRIES, own or "")
        if own is None:
            monkeypatch.delenv(RETRIES)
        assert isinstance(Store("http://server").client, MlflowClient)
        assert os.environ[RETRIES] == tries
