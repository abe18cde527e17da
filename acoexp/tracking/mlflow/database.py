"""SQLite databases: the address of one, and how they are opened by us, beside MLflow."""

from __future__ import annotations

import sqlite3
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
