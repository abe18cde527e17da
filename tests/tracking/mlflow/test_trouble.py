"""A disk that is full, a folder that cannot be written, a database that another holds: one line, and status 1."""

from __future__ import annotations

import os
import sqlite3
import subprocess
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
from running import run_acoexp, trials

from acoexp.errors import TrackingError
from acoexp.tracking.mlflow import making
from acoexp.tracking.mlflow.store import Store
from acoexp.tracking.mlflow.tracker import MlflowTracker

QUICK = ("algo=aco", "iterations=300", "ants=2")


@contextmanager
def mounted(folder: Path, *options: str) -> Iterator[None]:
    """Mount something at a folder for as long as it is needed."""
    if subprocess.run(["mount", *options, str(folder)], capture_output=True, check=False).returncode:
        pytest.skip("may not mount anything")
    try:
        yield
    finally:
        subprocess.run(["umount", "--lazy", str(folder)], check=True)


def statuses(file: Path) -> list[str]:
    """Return the states of all runs of a store, which is whole."""
    with closing(sqlite3.connect(file)) as database:
        assert database.execute("PRAGMA integrity_check").fetchall() == [("ok",)]
        return [status for (status,) in database.execute("SELECT status FROM runs")]


needs_root = pytest.mark.skipif(os.name != "posix" or os.geteuid() != 0, reason="mounts")


@needs_root
def test_a_disk_that_fills_up_ends_a_sweep_at_once_in_one_line_and_what_was_kept_stays(tmp_path: Path) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    with mounted(disk, "-t", "tmpfs", "-o", "size=2m", "tmpfs"):
        ended = run_acoexp(*QUICK, "-m", "seed=0-99", f"hydra.sweep.dir={tmp_path}/jobs", cwd=disk)
        assert ended.returncode == 1, ended.stderr
        (told,) = [line for line in ended.stderr.splitlines() if "compiling" not in line]
        assert told.startswith("acoexp: error: tracking.uri: sqlite:///")
        assert told.endswith("disk is full; make room there, then run the same command again")
        found = statuses(disk / "outputs" / "mlflow.db")
    assert found.count("FINISHED") == len(trials(tmp_path / "jobs")) >= 3
    assert len(found) - found.count("FINISHED") <= 1


@needs_root
def test_a_disk_too_small_for_a_store_is_told_in_one_line_and_left_empty(tmp_path: Path) -> None:
    with mounted(tmp_path, "-t", "tmpfs", "-o", "size=1m", "tmpfs"):
        ended = run_acoexp(*QUICK, "-m", "seed=0-1", cwd=tmp_path)
        assert (ended.returncode, ended.stderr.count("\n")) == (1, 1), ended.stderr
        assert "cannot be opened" in ended.stderr
        assert "is full; make room there" in ended.stderr
        assert [path.name for path in (tmp_path / "outputs").iterdir()] == ["mlflow.db.lock"]


@needs_root
def test_a_folder_that_cannot_be_written_is_told_in_one_line(tmp_path: Path) -> None:
    with mounted(tmp_path, "--bind", str(tmp_path)):
        subprocess.run(["mount", "-o", "remount,ro,bind", str(tmp_path)], check=True)
        ended = run_acoexp(*QUICK, "-m", "seed=0-1", cwd=tmp_path)
    assert (ended.returncode, ended.stderr.count("\n")) == (1, 1), ended.stderr
    assert "Read-only file system" in ended.stderr
    assert ended.stderr.endswith("; let the database and its folder be writable\n")


def test_a_database_that_another_program_holds_is_told_in_one_line(
    fresh: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(making, "BUSY", 0.1)
    store = Store(fresh)
    store.prepare()
    with closing(sqlite3.connect(store.file or "", isolation_level=None)) as other:
        other.execute("BEGIN EXCLUSIVE")
        with pytest.raises(TrackingError, match=r"database is locked; another program holds it: let that end"):
            MlflowTracker(fresh).prepare()
    MlflowTracker(fresh).prepare()


def test_a_store_that_another_command_does_not_stop_making_ready_is_told_of(
    fresh: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("acoexp.tracking.mlflow.store._LOCK_PATIENCE", 0.1)
    store = Store(fresh)
    with store._alone(), pytest.raises(TrackingError, match=r"could not be acquired.*; another program holds it"):
        Store(fresh).prepare()
