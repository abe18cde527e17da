"""What goes wrong with a store: told in one line with what to do, and waited for only where it may pass."""

from __future__ import annotations

import sqlite3

import pytest
from filelock import Timeout
from mlflow.exceptions import MlflowException
from mlflow.protos.databricks_pb2 import INTERNAL_ERROR, RESOURCE_DOES_NOT_EXIST, TEMPORARILY_UNAVAILABLE
from requests.exceptions import ReadTimeout
from sqlalchemy.exc import IntegrityError, OperationalError

from acoexp.tracking.mlflow.failures import may_pass, reason_of


def raised_by_sqlite(said: str, written: str = "x") -> OperationalError:
    """Return what SQLAlchemy raises where SQLite says something; it repeats what was to be written."""
    return OperationalError("INSERT INTO tags VALUES (?)", (written,), sqlite3.OperationalError(said))


def flushed(said: str) -> MlflowException:
    """Return what MLflow raises where SQLAlchemy wrote in passing, before it read."""
    when = "(raised as a result of Query-invoked autoflush; consider using a session.no_autoflush block)"
    return MlflowException(f"{when}\n{raised_by_sqlite(said)}", TEMPORARILY_UNAVAILABLE)


LASTING = ["database or disk is full", "attempt to write a readonly database", "database disk image is malformed"]


@pytest.mark.parametrize(
    "problem",
    [
        ConnectionError("reset"),
        ReadTimeout("read"),
        raised_by_sqlite("database is locked"),
        sqlite3.OperationalError("disk I/O error"),
        raised_by_sqlite("database is locked", written="reason: disk is full"),
        MlflowException(str(raised_by_sqlite("database is locked")), TEMPORARILY_UNAVAILABLE),
        MlflowException("restarting", TEMPORARILY_UNAVAILABLE),
    ],
)
def test_what_ends_by_itself_may_pass(problem: Exception) -> None:
    assert may_pass(problem)


@pytest.mark.parametrize(
    "problem",
    [
        ValueError("odd"),
        PermissionError(13, "odd"),
        OSError(28, "No space left on device", "outputs/artifacts/x"),
        IntegrityError("INSERT", {}, Exception("odd")),
        MlflowException("odd", RESOURCE_DOES_NOT_EXIST),
        MlflowException("could not extend file: No space left on device", INTERNAL_ERROR),
        *map(raised_by_sqlite, LASTING),
        *map(flushed, LASTING),
        *(MlflowException(str(raised_by_sqlite(said)), TEMPORARILY_UNAVAILABLE) for said in LASTING),
    ],
)
def test_what_stays_as_it_is_does_not_pass(problem: Exception) -> None:
    assert not may_pass(problem)


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        (ValueError("odd\nand more"), "odd"),
        (TimeoutError(), "TimeoutError"),
        (raised_by_sqlite("database or disk is full"), "disk is full; make room there"),
        (flushed("database or disk is full"), "disk is full; make room there"),
        (OSError(28, "No space left on device", "x"), "No space left on device: 'x'; make room there"),
        (
            raised_by_sqlite("attempt to write a readonly database"),
            "; let the database and its folder be writable",
        ),
        (raised_by_sqlite("database is locked"), "database is locked; another program holds it"),
        (Timeout("mlflow.db.lock"), "'mlflow.db.lock' could not be acquired.; another program holds it"),
        (sqlite3.DatabaseError("file is not a database"), "; put a copy of an MLflow database there"),
    ],
)
def test_it_is_told_in_one_line_with_what_to_do(problem: Exception, told: str) -> None:
    reason = reason_of(problem, "sqlite:///x.db")
    assert told in reason
    assert "\n" not in reason


def test_an_address_that_an_error_repeats_has_no_password() -> None:
    address = "http://me:s3c/ret@server"
    assert reason_of(ValueError(f"Failed to parse: {address}/api, port 's3c'"), address) == (
        "Failed to parse: http://***@server/api, port '***'"
    )
