"""SQLite databases: the address of one, and how they are opened by us, beside MLflow."""

from __future__ import annotations

import os
import sqlite3
import threading
from functools import lru_cache
from pathlib import Path

BUSY = 10.0
"""Seconds for which a database may be locked by another program before it is made ready."""


def address_of(file: Path, scheme: str = "sqlite:///") -> str:
    """Return the address of a database file, in which signs of an address's own are percent-encoded."""
    return scheme + str(file.absolute()).replace("%", "%25").replace("?", "%3F")


def reading(file: Path) -> sqlite3.Connection:
    """Open a database that is there.

    Raises:
        sqlite3.Error: if it is not.
    """
    # not read-only: what a killed process was writing could not be rolled back then
    return sqlite3.connect(f"{file.as_uri()}?mode=rw", uri=True, timeout=BUSY)


def kept_open(file: Path) -> sqlite3.Connection:
    """Return a connection to a database, the same one as long as this thread asks and the file is the same.

    Its tables are looked up once then, which takes longer than to look for a run.

    Raises:
        sqlite3.Error: if the database is not there.
    """
    try:
        there = file.stat()
    except OSError:
        return reading(file)
    return _kept(file, there.st_dev, there.st_ino, os.getpid(), threading.get_ident())


@lru_cache(maxsize=4)
def _kept(file: Path, *_: int) -> sqlite3.Connection:
    return reading(file)
