"""A report's folder: whether one may be written there, and the mark that tells it from a person's own."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from acoexp.errors import SettingsError, shown

MADE_BY = ".made-by.json"
"""File in a report's folder: by which settings it was made, and what it consists of."""

_LARGEST_MARK = 2**24
"""Bytes that such a file may have."""
_LONGEST_ENDING = 100
"""Bytes by which a name grows for a draft, or for a report that is kept under its date."""


def check_folder(folder: Path, avoided: Iterable[Path]) -> None:
    """Refuse a folder that somebody named where a report would take another thing's place, or cannot be written.

    Args:
        folder: It, from where the command runs.
        avoided: Places in use, which it may not be, nor lie above.

    Raises:
        SettingsError: unless it is new or empty, or has a report in it, and may be written.
    """
    try:
        there = _what_is(folder, avoided)
    except (OSError, ValueError) as problem:
        there = getattr(problem, "strerror", None) or str(problem)
    if there is not None:
        said = "report.folder: expected a new or an empty folder, or one with a report"
        raise SettingsError(f"{said}; got {shown(str(folder))}: {there}")


def _what_is(folder: Path, avoided: Iterable[Path]) -> str | None:
    """Say what stands against a folder; None if nothing does."""
    real = Path(os.path.realpath(folder))
    if any(Path(os.path.realpath(place)).is_relative_to(real) for place in avoided):
        return "the command itself runs in it, or writes there"
    if folder.is_symlink():
        return "a link"
    if os.path.lexists(real):
        if not real.is_dir():
            return "no folder"
        if os.path.ismount(real):
            return "the top of a disk, which nothing can take the place of; name a folder in it"
        if any(real.iterdir()) and not _is_plain(real / MADE_BY):
            return "other files are in it"
    elif len(os.fsencode(real.name)) + _LONGEST_ENDING > os.pathconf("/", "PC_NAME_MAX"):
        return "a name that is too long"
    above = next(place for place in real.parents if os.path.lexists(place))
    if not above.is_dir():
        return f"{above} is no folder"
    return None if os.access(above, os.W_OK | os.X_OK) else f"{above} may not be written"


def write_mark(folder: Path, made_by: Any) -> None:
    """Mark what is in a folder as a report.

    Args:
        folder: Where it is.
        made_by: All that it depends on, as JSON has it.
    """
    mark = {"made by": made_by, "files": {name: _digest(folder / name) for name in _names(folder)}}
    (folder / MADE_BY).write_text(json.dumps(mark, sort_keys=True) + "\n", encoding="utf-8")


def is_made_by(folder: Path, made_by: Any) -> bool:
    """Tell whether a folder has what :func:`write_mark` marked and nothing else; some of it may have been deleted.

    Where anything is in the way of knowing it is not.
    """
    try:
        if folder.is_symlink() or not _is_plain(folder / MADE_BY):
            return False
        with (folder / MADE_BY).open("rb") as file:
            mark = json.loads(file.read(_LARGEST_MARK))
        files = dict(mark["files"])
        if mark["made by"] != made_by or not files.keys() >= set(_names(folder)):
            return False
        return all(_digest(folder / name) == files[name] for name in _names(folder))
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return False


def is_empty(folder: Path) -> bool:
    """Tell whether a path is a folder, and nothing is in it."""
    try:
        return folder.is_dir() and not folder.is_symlink() and not any(folder.iterdir())
    except OSError:
        return False


def _names(folder: Path) -> list[str]:
    """Return the files in a report's folder by their paths there, links to folders among them.

    Raises:
        OSError: if a part of it may not be read.
    """
    found = []
    for path, folders, files in os.walk(folder, onerror=_raise):
        links = [name for name in folders if Path(path, name).is_symlink()]
        found += [Path(path, name).relative_to(folder).as_posix() for name in (*files, *links)]
    return sorted(name for name in found if name != MADE_BY)


def _raise(problem: OSError) -> None:
    raise problem


def _digest(path: Path) -> str:
    """Return the digest of a file; empty for what is none."""
    if not _is_plain(path):
        return ""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _is_plain(path: Path) -> bool:
    return path.is_file() and not path.is_symlink()
