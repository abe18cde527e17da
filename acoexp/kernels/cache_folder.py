"""The folder of the kernel cache. What lies in it is run, so it has to be this user's, and this user's alone."""

from __future__ import annotations

import logging
import os
import shutil
import stat
import time
from pathlib import Path

import platformdirs

log = logging.getLogger(__name__)

_UNUSED_AFTER = 60 * 24 * 3600.0


def cache_root() -> Path:
    """Return the folder of all kernel caches of this user."""
    return Path(platformdirs.user_cache_dir("acoexp")) / "kernels"


def usable_folder(digest: str) -> Path | None:
    """Return the folder for kernels of a digest, made if need be, with a file ``lock`` in it.

    None, and a warning, if there can be none: it cannot be written, this user has no home, or another user might
    have put something there.
    """
    try:
        folder = cache_root() / digest
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        _check_all_ours(folder)
        os.utime(folder)
        if not (folder / "lock").exists():
            _prune(folder.parent)
        (folder / "lock").open("a").close()  # one of another user's cannot be locked
    except (OSError, KeyError, RuntimeError) as problem:
        log.warning("the kernel cache cannot be used, so every process compiles for itself: %s", problem)
        return None
    return folder


def is_ours(path: Path) -> bool:
    """Tell whether a file or folder belongs to this user and nobody else can write to it; always, off POSIX."""
    if not hasattr(os, "getuid"):
        return True
    found = path.stat()
    return found.st_uid == os.getuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _check_all_ours(folder: Path) -> None:
    """Refuse a folder that another user owns or can write to, or could exchange by one that it lies in."""
    root = cache_root().parent
    for place in (folder, *folder.parents):
        if not (is_ours(place) if root in (place, *place.parents) else _is_steady(place)):
            raise PermissionError(f"{place} can be written by another user; expected it to be this user's alone")


def _is_steady(place: Path) -> bool:
    """Tell whether no other user can exchange what lies in a folder: root's, this user's, or one like /tmp."""
    if not hasattr(os, "getuid"):
        return True
    found = place.stat()
    others = found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    return found.st_uid in (0, os.getuid()) and (not others or bool(found.st_mode & stat.S_ISVTX))


def _prune(root: Path) -> None:
    """Remove what has not been asked for in sixty days."""
    for folder in root.iterdir():
        if time.time() - folder.stat().st_mtime > _UNUSED_AFTER:
            shutil.rmtree(folder, ignore_errors=True)
