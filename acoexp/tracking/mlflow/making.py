"""A SQLite store as a file: made whole or not at all, and refused where this MLflow could not open it.

MLflow makes a database in place, in a hundred steps, and one that a killed process left in the middle never opens
again. So it is made under another name, by whoever holds the store's lock.
"""

from __future__ import annotations

import os
import shutil
import sqlite3
import tempfile
from collections.abc import Callable
from contextlib import closing
from glob import escape
from pathlib import Path
from shlex import quote

from acoexp.errors import TrackingError
from acoexp.tracking.mlflow.database import BUSY, address_of, reading

_TABLES = ("runs", "tags", "params", "metrics", "latest_metrics", "experiment_tags")
"""Tables of MLflow's, beside that of the experiments, without which nothing can be kept."""


def make_whole(file: Path, make: Callable[[Path], object]) -> None:
    """Make a database unless it is there; drafts of processes that were killed meanwhile are removed.

    Args:
        file: The database.
        make: Makes a database at the place that it is given. It may keep that open: what takes the file's place
            is a copy.

    Raises:
        OSError, sqlite3.Error: if it cannot be made.
    """
    check_is_file(file)
    file = file.resolve()  # a link stays one
    if not file.parent.is_dir():
        raise FileNotFoundError(f"there is no folder {file.parent}")
    for left in file.parent.glob(f"{escape(_drafts(file))}*"):
        shutil.rmtree(left, ignore_errors=True)
    if _has_tables(file):
        return
    with tempfile.TemporaryDirectory(prefix=_drafts(file), dir=file.parent, ignore_cleanup_errors=True) as folder:
        first, whole = Path(folder, "first.db"), Path(folder, "whole.db")
        make(first)
        with closing(sqlite3.connect(first)) as database:
            database.execute("VACUUM INTO ?", (str(whole),))
        os.truncate(first, 0)  # the room that it takes would be kept as long as it is open
        for journal in (
            "-journal",
            "-wal",
            "-shm",
        ):  # of an earlier database: SQLite would play them in
            Path(f"{file}{journal}").unlink(missing_ok=True)
        whole.replace(file)


def check_is_file(file: Path) -> None:
    """Refuse a place where something else is than a file.

    Raises:
        OSError: if it is a folder, a pipe or a device, in whose place nothing is put.
    """
    if file.is_dir():
        raise IsADirectoryError(f"{file} is a folder")
    if file.exists() and not file.is_file():
        raise FileExistsError(f"{file.resolve()} is no file")


def check_writable(file: Path) -> None:
    """Take SQLite's lock for writing; MLflow would try again for minutes where that fails.

    Raises:
        OSError, sqlite3.Error: if it cannot be taken.
    """
    if not os.access(file, os.W_OK):
        raise PermissionError(f"{file} is read-only")
    with closing(sqlite3.connect(file, timeout=BUSY, isolation_level=None)) as database:
        database.execute("BEGIN IMMEDIATE")
        database.execute("ROLLBACK")


def check_openable(file: Path) -> None:
    """Refuse a database that this MLflow could not open, or would begin to change.

    Raises:
        TrackingError: if it is not there, was left half-made, or is another version's or another program's.
        sqlite3.Error: if it is no database at all.
    """
    fault = _fault_of(file) if _has_tables(file) else "is not there, or empty; has it been moved?"
    if fault is not None:
        raise TrackingError(f"tracking.uri: expected an MLflow database; {file} {fault}")


def _fault_of(file: Path) -> str | None:
    """Return what is wrong with the version of a database that has tables, and what to do."""
    from alembic.script import ScriptDirectory
    from alembic.util import CommandError

    script, version = ScriptDirectory(str(_migrations())), _version(file)
    if not _has(file, "pragma_table_info('experiments') WHERE name = 'artifact_location'"):
        return "has no experiments of MLflow's, so it is another program's, or damaged; name another file"
    if version in script.get_heads():
        lacking = [table for table in _TABLES if not _has(file, f"sqlite_master WHERE name = '{table}'")]
        return f"is damaged, as it lacks the table {lacking[0]}; put a copy of it there" if lacking else None
    if not _has(file, "experiments"):
        return "was left half-made by a process that was killed, with nothing in it; delete it and run this again"
    try:
        script.get_revision(version or "base")
    except CommandError:
        return "was written by a newer MLflow; install that: pip install --upgrade mlflow"
    upgrade = f"mlflow db upgrade {quote(address_of(file))}"
    return f"was written by an older MLflow; keep a copy of it, then run: {upgrade}"


def _migrations() -> Path:
    """Return the folder of MLflow's that tells which versions of a database there are; it has no call for that."""
    import mlflow

    return Path(mlflow.__file__).parent / "store" / "db_migrations"


def _version(file: Path) -> str | None:
    """Return the version of MLflow's tables, as far as they were made."""
    if not _has(file, "sqlite_master WHERE name = 'alembic_version'"):
        return None
    with closing(reading(file)) as database:
        row = database.execute("SELECT version_num FROM alembic_version").fetchone()
    return None if row is None else str(row[0])


def _has_tables(file: Path) -> bool:
    """Tell whether a file is there and is a database with anything in it; SQLite makes an empty one by looking."""
    return file.is_file() and _has(file, "sqlite_master")


def _has(file: Path, rows: str) -> bool:
    with closing(reading(file)) as database:
        return database.execute(f"SELECT 1 FROM {rows} LIMIT 1").fetchone() is not None


def _drafts(file: Path) -> str:
    return f".{file.name}-draft-"
