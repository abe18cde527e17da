"""Artifacts of a store that was moved or copied: they are found beside its database, and new ones go there.

MLflow keeps their absolute places in the database and has no call that changes them. So this is SQL, over two
columns of MLflow's tables, and a test holds them against the tables that MLflow makes.
"""

from __future__ import annotations

import logging
import sqlite3
from contextlib import closing
from pathlib import Path
from urllib.parse import urlsplit

from acoexp.tracking.mlflow.database import BUSY, reading

log = logging.getLogger(__name__)

ARTIFACTS = "artifacts"
"""Folder beside a local database in which artifacts lie."""


def bring_artifacts_along(file: Path, experiment: str) -> None:
    """Name the folder beside a database as the place of an experiment's artifacts, if both were moved or copied.

    A place that somebody chose for them elsewhere stays.

    Args:
        file: The database, which nobody else makes ready meanwhile.
        experiment: The experiment's name.

    Raises:
        sqlite3.Error: if the database cannot be read or written.
    """
    beside = file.parent / ARTIFACTS
    with closing(sqlite3.connect(file, timeout=BUSY)) as database:
        row = _place_of(database, experiment)
        if row is not None and _was_beside(file, row[1], beside):
            with database:
                _rename(database, row[0], row[1], beside.as_uri())
            log.warning("%s was moved or copied: its artifacts are now those in %s", file, beside)


def is_away(file: Path, experiment: str) -> bool:
    """Tell whether a database was moved or copied since its artifacts were last brought along.

    Raises:
        sqlite3.Error: if the database cannot be read.
    """
    with closing(reading(file)) as database:
        row = _place_of(database, experiment)
    return row is not None and _was_beside(file, row[1], file.parent / ARTIFACTS)


def _place_of(database: sqlite3.Connection, experiment: str) -> tuple[int, str] | None:
    """Return an experiment's number, and the place of its artifacts; None if there is no such experiment."""
    row: tuple[int, str] | None = database.execute(
        "SELECT experiment_id, artifact_location FROM experiments WHERE name = ?", (experiment,)
    ).fetchone()
    return row


def _rename(database: sqlite3.Connection, experiment_id: int, old: str, new: str) -> None:
    """Put one place for another in an experiment and in all of its runs."""
    database.execute("UPDATE experiments SET artifact_location = ? WHERE experiment_id = ?", (new, experiment_id))
    database.execute(
        "UPDATE runs SET artifact_uri = ? || substr(artifact_uri, ?) "
        "WHERE experiment_id = ? AND substr(artifact_uri, 1, ?) = ?",
        (new, len(old) + 1, experiment_id, len(old) + 1, f"{old}/"),
    )


def _was_beside(file: Path, location: str, beside: Path) -> bool:
    """Tell whether a place of artifacts is the one beside where the database was before, or where its original is.

    One that is there without a database beside it was chosen.
    """
    old = local_folder(location)
    if old is None or old.name != ARTIFACTS or old == beside:
        return False
    if not old.parent.is_dir():
        return True
    if old.parent.samefile(beside.parent):  # by another name, such as a link
        return False
    original = (old.parent / file.name).is_file() or any(old.parent.glob("*.db"))
    return original or (beside.is_dir() and not old.is_dir())


def local_folder(location: str) -> Path | None:
    """Return the folder that a place of artifacts is, an address or a plain path; None for one elsewhere."""
    address = urlsplit(location)
    if address.scheme == "file":
        from urllib.request import url2pathname  # brings all of http and ssl along

        return Path(url2pathname(address.path))
    return None if address.scheme else Path(location)
