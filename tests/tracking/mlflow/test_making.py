"""A SQLite store as a file: whole or not there, whoever is killed; refused, with what to do, if it is neither."""

from __future__ import annotations

import os
import re
import shutil
import signal
import sqlite3
import time
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from forked import forking
from mlflow import MlflowClient

from acoexp.errors import TrackingError
from acoexp.tracking.mlflow.making import check_openable, check_writable, make_whole
from acoexp.tracking.mlflow.store import Store

HALF_MADE = "3500859a5d39"
"""A version in the middle of those that MLflow goes through."""


def sql(file: Path, *statements: str) -> None:
    """Change a database behind MLflow's back."""
    with closing(sqlite3.connect(file)) as database, database:
        for statement in statements:
            database.execute(statement)


def one_table(draft: Path) -> None:
    """Make a database."""
    sql(draft, "CREATE TABLE made (x)")


@pytest.fixture
def database(fresh: str) -> Path:
    """Return MLflow's database, with nothing in it."""
    return Path(fresh.removeprefix("sqlite:///"))


# --- made whole or not at all


@pytest.mark.skipif(os.name != "posix", reason="kills")
def test_whoever_is_killed_while_it_makes_a_store_leaves_none_and_the_next_makes_it(tmp_path: Path) -> None:
    context, file = forking(), tmp_path / "new" / "mlflow.db"
    for after in (0.0, 0.05, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8):  # seconds since its first file; the whole takes one
        maker = context.Process(target=Store(f"sqlite:///{file}").prepare)
        maker.start()
        until(lambda: any(file.parent.glob(".*/*")))
        time.sleep(after)
        os.kill(maker.pid or 0, signal.SIGKILL if after else signal.SIGTERM)
        maker.join()
        if file.exists():  # this machine is a fast one
            check_openable(file)
            file.unlink()
    store = Store(f"sqlite:///{file}")
    store.prepare()
    assert [run.info.run_id for run in store.search("")] == []
    assert {path.name for path in file.parent.iterdir()} == {"mlflow.db", "mlflow.db.lock"}


def until(is_so: Callable[[], bool]) -> None:
    """Wait until something is so."""
    deadline = time.monotonic() + 60.0
    while not is_so():
        assert time.monotonic() < deadline
        time.sleep(0.002)


def test_a_database_is_made_where_there_is_none_or_an_empty_one(tmp_path: Path) -> None:
    for name, content in (("none.db", None), ("touched.db", b"")):
        if content is not None:
            (tmp_path / name).write_bytes(content)
        make_whole(tmp_path / name, one_table)
        sql(tmp_path / name, "INSERT INTO made VALUES (1)")
        make_whole(tmp_path / name, lambda draft: pytest.fail("it is there"))
    assert {path.name for path in tmp_path.iterdir()} == {"none.db", "touched.db"}


def test_after_an_error_there_is_none(tmp_path: Path) -> None:
    def fails(draft: Path) -> None:
        one_table(draft)
        raise RuntimeError("disk full")

    with pytest.raises(RuntimeError, match="disk full"):
        make_whole(tmp_path / "x.db", fails)
    assert list(tmp_path.iterdir()) == []


def test_what_an_earlier_database_was_writing_is_not_played_into_the_new_one(tmp_path: Path) -> None:
    for journal in ("-journal", "-wal", "-shm"):
        (tmp_path / f"x.db{journal}").write_bytes(b"of another database")
    make_whole(tmp_path / "x.db", one_table)
    assert [path.name for path in tmp_path.iterdir()] == ["x.db"]


def test_what_was_made_may_stay_open_and_is_another_file(tmp_path: Path) -> None:
    opened = []

    def stays_open(draft: Path) -> None:
        one_table(draft)
        opened.append(sqlite3.connect(draft))
        opened[0].execute("SELECT * FROM made").fetchall()

    make_whole(tmp_path / "x.db", stays_open)
    sql(tmp_path / "x.db", "INSERT INTO made VALUES (1)")
    opened[0].close()
    with closing(sqlite3.connect(tmp_path / "x.db")) as database:
        assert database.execute("SELECT * FROM made").fetchall() == [(1,)]


def test_a_link_to_a_database_stays_one(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    (tmp_path / "x.db").symlink_to(tmp_path / "far" / "y.db")
    make_whole(tmp_path / "x.db", one_table)
    assert (tmp_path / "x.db").is_symlink()
    assert [path.name for path in (tmp_path / "far").iterdir()] == ["y.db"]


@pytest.mark.skipif(os.name != "posix", reason="pipes")
@pytest.mark.parametrize("linked", [False, True])
def test_in_the_place_of_a_pipe_or_a_device_no_database_is_put(linked: bool, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    file = tmp_path / "pipe"
    if linked:
        file = tmp_path / "link.db"
        file.symlink_to(tmp_path / "pipe")
    with pytest.raises(TrackingError, match=f"cannot be opened: {tmp_path}/pipe is no file$"):
        Store(f"sqlite:///{file}").prepare()
    assert (tmp_path / "pipe").is_fifo()


def test_a_link_into_a_folder_that_is_not_there_is_told(tmp_path: Path) -> None:
    (tmp_path / "link.db").symlink_to(tmp_path / "gone" / "x.db")
    with pytest.raises(TrackingError, match=f"there is no folder {tmp_path}/gone$"):
        Store(f"sqlite:///{tmp_path}/link.db").prepare()


def test_a_folder_is_no_place_for_a_database(tmp_path: Path) -> None:
    with pytest.raises(IsADirectoryError, match="is a folder"):
        make_whole(tmp_path, one_table)


# --- refused with what to do


def test_what_this_mlflow_made_is_opened(database: Path) -> None:
    check_openable(database)
    check_writable(database)


def test_a_store_that_an_older_version_left_half_made_is_to_be_deleted(database: Path) -> None:
    nothing = "DELETE FROM experiments"
    for half in (f"UPDATE alembic_version SET version_num = '{HALF_MADE}'", "DELETE FROM alembic_version",
                 "DROP TABLE alembic_version"):  # fmt: skip
        sql(database, nothing, half)
        with pytest.raises(TrackingError, match=r"fresh\.db was left half-made .* nothing in it; delete it"):
            check_openable(database)


def test_a_store_of_an_older_mlflow_is_to_be_upgraded_and_is_not_touched(database: Path) -> None:
    sql(database, f"UPDATE alembic_version SET version_num = '{HALF_MADE}'", "DROP TABLE jobs")
    before = database.read_bytes()
    said = f"older MLflow; keep a copy of it, then run: mlflow db upgrade sqlite:///{database}"
    with pytest.raises(TrackingError, match=re.escape(said)):
        Store(f"sqlite:///{database}").prepare()
    assert database.read_bytes() == before


def test_a_store_of_a_newer_mlflow_wants_that(database: Path) -> None:
    sql(database, "UPDATE alembic_version SET version_num = 'ffffffffffff'")
    with pytest.raises(TrackingError, match=r"newer MLflow; install that: pip install --upgrade mlflow"):
        check_openable(database)


def test_the_database_of_another_program_is_not_touched(tmp_path: Path) -> None:
    one_table(tmp_path / "x.db")
    before = (tmp_path / "x.db").read_bytes()
    with pytest.raises(
        TrackingError, match=r"x\.db has no experiments of MLflow's, so it is another program's, or damaged"
    ):
        Store(f"sqlite:///{tmp_path}/x.db").prepare()
    assert (tmp_path / "x.db").read_bytes() == before


@pytest.mark.parametrize("versions", [[], ["CREATE TABLE alembic_version (version_num)"]])
def test_the_database_of_another_program_that_knows_experiments_is_not_touched(
    versions: list[str], tmp_path: Path
) -> None:
    file = tmp_path / "lab.db"
    sql(file, "CREATE TABLE experiments (name)", "INSERT INTO experiments VALUES ('a')", *versions)
    before = file.read_bytes()
    with pytest.raises(TrackingError, match="is another program's, or damaged; name another file"):
        Store(f"sqlite:///{file}").prepare()
    assert file.read_bytes() == before


@pytest.mark.parametrize("table", ["runs", "tags", "params", "metrics", "latest_metrics", "experiment_tags"])
def test_a_store_that_lacks_a_table_is_refused_at_once_and_not_touched(table: str, database: Path) -> None:
    Store(f"sqlite:///{database}").prepare()
    sql(database, "PRAGMA foreign_keys = OFF", f"DROP TABLE {table}")
    before = database.read_bytes()
    with pytest.raises(TrackingError, match=f"is damaged, as it lacks the table {table}; put a copy of it there$"):
        check_openable(database)
    assert database.read_bytes() == before


def test_a_store_without_experiments_is_refused_at_once_and_not_touched(database: Path) -> None:
    Store(f"sqlite:///{database}").prepare()
    sql(database, "PRAGMA foreign_keys = OFF", "DROP TABLE experiments")
    before = database.read_bytes()
    with pytest.raises(TrackingError, match="has no experiments of MLflow's"):
        check_openable(database)
    assert database.read_bytes() == before


def test_a_database_that_is_gone_is_not_made_by_who_only_uses_it(tmp_path: Path) -> None:
    with pytest.raises(TrackingError, match=r"x\.db is not there, or empty; has it been moved\?"):
        Store(f"sqlite:///{tmp_path}/x.db").search("")
    assert list(tmp_path.iterdir()) == []


def test_what_a_killed_process_was_writing_is_rolled_back(database: Path) -> None:
    copy = database.with_name("copy.db")
    with closing(sqlite3.connect(database, isolation_level=None)) as writing:
        writing.execute("PRAGMA cache_size = 1")  # so that it is on the disk before it is finished
        writing.execute("BEGIN")
        writing.executemany(
            "INSERT INTO experiment_tags VALUES (?, ?, 0)", [(f"{n}", "x" * 999) for n in range(999)]
        )
        for file in (database, Path(f"{database}-journal")):
            shutil.copy(file, str(file).replace("fresh.db", "copy.db"))
    check_openable(copy)
    assert MlflowClient(f"sqlite:///{copy}").get_experiment("0").tags == {}
