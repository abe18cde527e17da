"""Reading a map's file: whole, if it is a file, and no larger than a map can be."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from acoexp.errors import MapError, shown

LARGEST = 8 * 2**20
"""Bytes that a map's file may have: 2048 x 2048 cells, a sign and a blank each."""

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
    try:
        path = Path(text).expanduser()
        return path, _content(path, text, key).decode("utf-8-sig")
    except MapError:
        raise
    except UnicodeDecodeError as problem:
        raise MapError(f"{key}: expected a text file in UTF-8; got {shown(text)}") from problem
    except (OSError, ValueError, RuntimeError) as problem:
        raise _refusal(key, text, getattr(problem, "strerror", None) or str(problem)) from problem


def _content(path: Path, text: str, key: str) -> bytes:
    kind = _KINDS.get(stat.S_IFMT(path.stat().st_mode))
    if kind is not None:
        raise _refusal(key, text, kind)
    # some files of the system's have nothing to read yet, and would be waited for
    with open(path, "rb", opener=lambda name, flags: os.open(name, flags | os.O_NONBLOCK)) as file:
        content = file.read(LARGEST + 1) or b""
    if len(content) > LARGEST:
        raise _refusal(key, text, f"more than {LARGEST // 2**20} MiB, the most that a map may have")
    return content


def _refusal(key: str, text: str, reason: str) -> MapError:
    return MapError(f"{key}: expected a readable text file; got {shown(text)} ({reason})")
