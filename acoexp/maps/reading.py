"""Reading a map's file: whole, if it is a file, and no larger than a map or its image can be."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from acoexp.errors import MapError, shown

LARGEST = 8 * 2**20
"""Bytes that a map's file may have: 2048 x 2048 cells, a sign and a blank each."""

LARGEST_IMAGE = 2**28
"""Bytes that an image may have: four for each of the pixels that it may have (see ``pixels.MOST``)."""

LONGEST_SIDE, MOST_CELLS = 16_384, 2048 * 2048
"""Rows, columns and cells that a map from a text may have."""

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}
"""What is no file, and would be read without an end, or waited for."""


def read_text(text: str, key: str) -> tuple[Path, str]:
    """Return the path that a text names, and what is in that file.

    Args:
        text: The path, relative to the working directory; ``~`` is the home directory.
        key: The key that it was given by, for messages.

    Raises:
        MapError: if it is no readable file of text in UTF-8, or larger than ``LARGEST``.
    """
    path, content = read_bytes(text, key, "text file")
    try:
        return path, content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise MapError(f"{key}: expected a text file in UTF-8; got {shown(text)}") from problem


def read_bytes(text: str, key: str, what: str, largest: int = LARGEST) -> tuple[Path, bytes]:
    """Return the path that a text names, and the bytes of that file.

    Args:
        text: The path, as for :func:`read_text`.
        key: The key that it was given by, for messages.
        what: What is expected, for messages.
        largest: How many bytes it may have.

    Raises:
        MapError: if it is no readable file, or larger.
    """
    path = named_path(text, key)
    return path, _content(path, text, key, largest, what)


def read_image(path: Path, key: str) -> bytes:
    """Return what is in a file that shall be an image.

    Args:
        path: The file.
        key: The key that it was given by, for messages.

    Raises:
        MapError: if it is no readable file, or larger than ``LARGEST_IMAGE``.
    """
    return _content(path, str(path), key, LARGEST_IMAGE, "image")


def named_path(text: str, key: str) -> Path:
    """Return the path that a text names, ``~`` being the home directory.

    Raises:
        MapError: for a home directory that nobody has.
    """
    try:
        return Path(text).expanduser()
    except RuntimeError as problem:
        raise _refusal(key, text, str(problem), "file") from problem


def check_size(rows: int, cols: int, name: str) -> None:
    """Refuse a map that is larger than one from a text may be, before anything is made of it.

    Raises:
        MapError: if it is.
    """
    if max(rows, cols) > LONGEST_SIDE or rows * cols > MOST_CELLS:
        raise MapError(
            f"map {name}: expected at most {LONGEST_SIDE} rows and columns, and {MOST_CELLS} cells; got "
            f"{shown(rows)} x {shown(cols)}"
        )


def _content(path: Path, text: str, key: str, largest: int, what: str) -> bytes:
    """Return what is in a file, if it is one."""
    try:
        kind = _KINDS.get(stat.S_IFMT(path.stat().st_mode))
        if kind is not None:
            raise _refusal(key, text, kind, what)
        # some files of the system's have nothing to read yet, and would be waited for
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | os.O_NONBLOCK)) as file:
            content = file.read(largest + 1) or b""
    except MapError:
        raise
    except (OSError, ValueError) as problem:
        raise _refusal(key, text, getattr(problem, "strerror", None) or str(problem), what) from problem
    if len(content) > largest:
        raise _refusal(key, text, f"more than {largest // 2**20} MiB, the most that a map may have", what)
    return content


def _refusal(key: str, text: str, reason: str, what: str) -> MapError:
    return MapError(f"{key}: expected a readable {what}; got {shown(text)} ({reason})")
