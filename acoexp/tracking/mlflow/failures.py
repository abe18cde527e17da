"""What goes wrong with a store: whether it passes by itself, and what is said of it."""

from __future__ import annotations

import re
import sqlite3
from typing import NamedTuple

from acoexp.tracking.mlflow.masking import masked


class _Known(NamedTuple):
    """What MLflow, SQLAlchemy or the system say of a failure, whether it lasts, and what a person can do."""

    said: str
    lasts: bool
    advice: str


_KNOWN = (
    _Known("disk is full|No space left|quota exceeded", True, "make room there, then run the same command again"),
    _Known("readonly database|read-only|Permission denied", True, "let the database and its folder be writable"),
    _Known("unable to open database", True, "has it been moved?"),
    _Known("malformed|not a database", True, "put a copy of an MLflow database there, or name another file"),
    _Known("database is locked|file lock", False, "another program holds it: let that end, then run this again"),
)


def lasts(problem: Exception) -> bool:
    """Tell whether a store takes nothing any more, until a person does something about it: the disk is full."""
    known = _known(problem)
    return known is not None and known.lasts


def may_pass(problem: Exception) -> bool:
    """Tell whether a failure is of the kind that ends by itself: no connection, a locked database, a restart."""
    from mlflow.exceptions import MlflowException
    from requests.exceptions import RequestException
    from sqlalchemy.exc import InterfaceError, OperationalError

    if isinstance(problem, MlflowException):
        passing = ("TEMPORARILY_UNAVAILABLE", "INTERNAL_ERROR", "REQUEST_LIMIT_EXCEEDED", "BAD_REQUEST")
        return problem.error_code in passing and not lasts(problem)
    if isinstance(problem, sqlite3.OperationalError):
        return "locked" in str(problem) or "disk I/O" in str(problem)
    passing_kinds = RequestException | OperationalError | InterfaceError | ConnectionError | TimeoutError
    return isinstance(problem, passing_kinds) and not lasts(problem)


def reason_of(problem: Exception, address: str) -> str:
    """Return in one line what went wrong with the store at an address, and what to do where that is known."""
    known = _known(problem)
    return masked(line_of(problem), address) + (f"; {known.advice}" if known is not None else "")


def _known(problem: Exception) -> _Known | None:
    said = line_of(problem)
    return next((known for known in _KNOWN if re.search(known.said, said, re.IGNORECASE)), None)


def line_of(problem: Exception) -> str:
    """Return the line that says what went wrong; SQLAlchemy puts others around it."""
    lines = (line.strip() for line in str(problem).splitlines())
    said = (line for line in lines if line and not line.startswith("(raised as a result of"))
    return next(said, type(problem).__name__)
