"""Reading a map's file: whole, if it is a file, and no larger than a map can be."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from acoexp.errors import MapError, shown

LARGEST = 8 * 2**20
"""Bytes that a map's file may have: 2048 x 2048 cells, a sign and a blank each."""

LONGEST_SIDE, MOST_CELLS = 16_384, 2048 * 2048
"""Rows, columns and cells that a map from a file may have; a grid takes some 300 bytes a cell while it is made."""

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
    path, content = read_bytes(text, key)
    try:
        return path, content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise MapError(f"{key}: expected a text file in UTF-8; got {shown(text)}") from problem


def read_bytes(text: str, key: str, kind: str = "text", largest: int = LARGEST) -> tuple[Path, bytes]:
    """Return the path that a text names, and the bytes of that file.

    Args:
        text: The path, as for :func:`read_text`.
        key: The key that it was given by, for messages.
        kind: What kind of file is expected, for messages.
        largest: How many bytes it may have.

    Raises:
        MapError: if it is no readable file, or larger.
    """
    try:
        path = Path(text).expanduser()
        return path, _content(path, largest)
    except (OSError, ValueError, RuntimeError) as problem:
        reason = getattr(problem, "strerror", None) or str(problem)
        raise MapError(f"{key}: expected a readable {kind} file; got {shown(text)} ({reason})") from problem


def check_size(rows: int, cols: int, name: str) -> None:
    """Refuse a map that is larger than one from a file may be, before anything is made of it.

    Raises:
        MapError: if it is.
    """
    if max(rows, cols) > LONGEST_SIDE or rows * cols > MOST_CELLS:
        raise MapError(
            f"map {name}: expected at most {LONGEST_SIDE} rows and columns, and {MOST_CELLS} cells; got "
            f"{shown(rows)} x {shown(cols)}"
        )


def _content(path: Path, largest: int) -> bytes:
    kind = _KINDS.get(stat.S_IFMT(path.stat().st_mode))
    if kind is not None:
        raise ValueError(kind)
    # some files of the system's have nothing to read yet, and would be waited for
    with open(path, "rb", opener=lambda name, flags: os.open(name, flags | os.O_NONBLOCK)) as file:
        content = file.read(largest + 1) or b""
    if len(content) > largest:
        raise ValueError(f"more than {largest // 2**20} MiB, the most that a map may have")
    return content
