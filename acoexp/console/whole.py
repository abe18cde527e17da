"""Files and folders that are there whole or not at all, whatever happens while they are written.

Each is written as a draft beside it, ``.name-host-process-draft``, and then takes its place at once. A draft that
a killed process left is removed by the next one that writes the same.
"""

from __future__ import annotations

import os
import re
import shutil
import socket
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import cache
from pathlib import Path

from acoexp.console.exchange import exchange


def write_whole(file: Path, content: str | bytes) -> None:
    """Write a file, or leave the one that is there as it is."""
    with whole_file(file) as draft:
        draft.write_bytes(content.encode() if isinstance(content, str) else content)


@contextmanager
def whole_file(file: Path) -> Iterator[Path]:
    """Give a draft to write, which then replaces ``file``; after an error nothing has changed."""
    _remove_left_behind(file, _listed(file.parent))
    draft = _beside(file, "draft")
    try:
        yield draft
        draft.replace(file)
    except OSError as problem:
        raise _naming(file, problem) from problem
    finally:
        draft.unlink(missing_ok=True)


@contextmanager
def whole_folder(folder: Path, keep: Path | None = None) -> Iterator[Path]:
    """Give a draft folder to write to, which then replaces ``folder``; after an error nothing has changed.

    Args:
        folder: What is to be written.
        keep: Where what was there before goes; it is removed if that is not said.
    """
    folder.parent.mkdir(parents=True, exist_ok=True)
    _remove_left_behind(folder, list(folder.parent.iterdir()))
    draft = _beside(folder, "draft")
    _remove(draft)  # of a process that had this number and was killed
    draft.mkdir()
    try:
        yield draft
        _replace(folder, draft, keep)
    except OSError as problem:
        raise _naming(folder, problem) from problem
    finally:
        _remove(draft)


def _naming(path: Path, problem: OSError) -> OSError:
    """Return an error that names what was to be written, where the system names nothing: the disk is full."""
    if problem.filename is not None or problem.errno is None:
        return problem
    return OSError(problem.errno, problem.strerror, str(path))


def _replace(folder: Path, draft: Path, keep: Path | None) -> None:
    """Let a draft take a folder's place, at no moment of which there is none, if the system can do that."""
    if not os.path.lexists(folder):
        draft.replace(folder)
    elif keep is None:
        _swap(draft, folder)
    else:
        draft.replace(keep)  # first, as a draft of a killed process would be removed, and the old one with it
        try:
            _swap(keep, folder)
        except BaseException:
            _remove(keep)
            raise


def _swap(new: Path, folder: Path) -> None:
    """Let the new folder and the old one swap their names."""
    if exchange(new, folder):
        return
    old = _beside(folder, "old")
    folder.replace(old)
    try:
        new.replace(folder)
    except BaseException:
        old.replace(folder)
        raise
    old.replace(new)


def _remove_left_behind(path: Path, entries: list[Path]) -> None:
    """Remove drafts of a file or folder whose process is gone; bring back what such a process had set aside."""
    mark = re.compile(rf"\.{re.escape(path.name)}-(?:{re.escape(_host())}-)?(\d{{1,9}})-(draft|old)")
    for entry in entries:
        found = mark.fullmatch(entry.name)
        if found is None or _lives(int(found[1])):
            continue
        if found[2] == "old" and not os.path.lexists(path):
            entry.replace(path)
        _remove(entry)


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        with suppress(OSError):
            path.unlink(missing_ok=True)


def _beside(path: Path, what: str) -> Path:
    """Return a name for this process alone, also on a disk that other machines write."""
    return path.with_name(f".{path.name}-{_host()}-{os.getpid()}-{what}")


@cache
def _listed(folder: Path) -> list[Path]:
    """Return what is in a folder, looked up once: some files are written again and again."""
    return list(folder.iterdir()) if folder.is_dir() else []


@cache
def _host() -> str:
    return socket.gethostname()


def _lives(number: int) -> bool:
    """Tell whether there is another process of a number; one that has ended may still be listed."""
    if number == os.getpid():  # which has written nothing yet
        return False
    import psutil  # takes its time to import, and is hardly ever needed

    try:
        status: str = psutil.Process(number).status()
    except psutil.NoSuchProcess:
        return False
    return status != psutil.STATUS_ZOMBIE
