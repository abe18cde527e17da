"""Looking up in a local database: what is found is what MLflow itself finds, and reads in the same way."""

from __future__ import annotations

import math
import shutil
import sqlite3
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from pathlib import Path

import pytest
from mlflow.entities import Run

from acoexp.tracking.mlflow.lookup import LocalRun, runs_with
from acoexp.tracking.mlflow.store import EXPERIMENT, Store


def kept(store: Store, identity: str, *, status: str = "FINISHED", **metrics: float) -> str:
    """Keep a run; return its id."""
    run = store.client.create_run(
        store.experiment_id, tags={"identity": identity, "kind": "it's"}, run_name="a name"
    )
    for key, value in metrics.items():
        for step in range(2):
            store.client.log_metric(run.info.run_id, key, value + step, step=step)
    store.client.set_terminated(run.info.run_id, status)
    return str(run.info.run_id)


def looked_up(store: Store, *identities: str) -> list[LocalRun]:
    return runs_with(store.file or Path(), EXPERIMENT, "identity", identities)


def as_said(run: Run | LocalRun) -> tuple[object, ...]:
    """Return what is compared of a run."""
    metrics = {key: "nan" if math.isnan(value) else value for key, value in run.data.metrics.items()}
    return run.info.run_id, run.info.start_time, run.info.status, metrics, dict(run.data.tags)


def test_it_reads_of_each_run_what_mlflow_reads(store: Store) -> None:
    wanted = ["a", "b's", 'c"', "d,e"]
    for identity in [*wanted, "b's", "another"]:
        kept(store, identity, optimum=30.5, odd=math.nan, large=math.inf, small=-math.inf, zero=-0.0)
    by_mlflow = [run for identity in wanted for run in store.search(f"tags.identity = {quoted(identity)}")]
    assert len(by_mlflow) == 5
    assert sorted(map(as_said, looked_up(store, *wanted))) == sorted(map(as_said, by_mlflow))


def test_a_database_that_takes_the_place_of_another_is_looked_into(
    store: Store, identity: str, tmp_path: Path
) -> None:
    other = Store(f"sqlite:///{tmp_path}/other.db")
    other.prepare()
    run = kept(other, identity)
    here, there = store.file or Path(), other.file or Path()
    aside = here.with_name("aside.db")
    assert looked_up(store, identity) == []
    here.rename(aside)
    try:
        with pytest.raises(sqlite3.Error):
            looked_up(store, identity)
        shutil.copy(there, here)
        assert [found.info.run_id for found in looked_up(store, identity)] == [run]
    finally:
        aside.replace(here)
    assert looked_up(store, identity) == []


def test_each_thread_looks_by_itself(store: Store, identity: str) -> None:
    run = kept(store, identity)
    with ThreadPoolExecutor(2) as threads:
        found = [threads.submit(looked_up, store, identity).result() for _ in range(4)]
    assert [[one.info.run_id for one in some] for some in (*found, looked_up(store, identity))] == [[run]] * 5


def quoted(text: str) -> str:
    return f"'{text}'" if "'" not in text else f'"{text}"'


def test_what_is_not_deleted_is_found_with_what_became_of_it(store: Store, identity: str) -> None:
    store.client.delete_run(kept(store, identity))
    assert looked_up(store, identity) == []
    kinds = ("FAILED", "KILLED", "RUNNING", "FINISHED")
    runs = {kept(store, identity, status=status): status for status in kinds}
    assert {run.info.run_id: run.info.status for run in looked_up(store, identity)} == runs


def test_what_a_person_wrote_in_a_numbers_place_is_none(store: Store, identity: str) -> None:
    run_id = kept(store, identity, optimum=29.5, l1=31.0)
    with closing(sqlite3.connect(store.file or "")) as database, database:
        database.execute("UPDATE latest_metrics SET value = 'abc' WHERE key = 'l1' AND run_uuid = ?", (run_id,))
        database.execute("UPDATE runs SET start_time = NULL WHERE run_uuid = ?", (run_id,))
    (run,) = looked_up(store, identity)
    assert math.isnan(run.data.metrics["l1"])
    assert (run.data.metrics["optimum"], run.info.start_time) == (30.5, 0)
    store.client.delete_run(run_id)


def test_nothing_of_another_experiment_or_a_deleted_one_is_found(fresh: str) -> None:
    store = Store(fresh)
    store.prepare()
    kept(store, "mine")
    other = store.client.create_experiment("another")
    store.client.set_terminated(store.client.create_run(other, tags={"identity": "theirs"}).info.run_id)
    assert [len(looked_up(store, identity)) for identity in ("mine", "theirs")] == [1, 0]
    store.client.delete_experiment(store.experiment_id)
    assert looked_up(store, "mine") == []


def test_thousands_are_looked_up_at_once(store: Store, identity: str) -> None:
    run_id = kept(store, identity)
    found = looked_up(store, identity, *map("nothing {}".format, range(50_000)))
    assert [run.info.run_id for run in found] == [run_id]


def test_a_database_that_is_not_there_is_not_made(tmp_path: Path) -> None:
    with pytest.raises(sqlite3.OperationalError):
        runs_with(tmp_path / "mlflow.db", EXPERIMENT, "identity", ["x"])
    assert [*tmp_path.iterdir()] == []


def test_a_database_of_another_program_is_refused(tmp_path: Path) -> None:
    with closing(sqlite3.connect(tmp_path / "other.db")) as database:
        database.execute("CREATE TABLE tags (key, value)")
    with pytest.raises(sqlite3.OperationalError, match="no such"):
        runs_with(tmp_path / "other.db", EXPERIMENT, "identity", ["x"])
