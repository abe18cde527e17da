"""The kernel cache: a colony is compiled once per machine, and never runs code that has been edited since.

numba's own cache looks at one file's time stamp and cannot keep closures. This one keeps a file per signature
in a folder per digest, and the digest covers everything that the machine code depends on: Python, numba, the
processor, and every source file of acoexp's and of each part's own top-level package. It stands on numba's
``_Cache`` interface, which is semi-private: pyproject.toml pins numba's minor version.

What lies in the cache is run, so its folder has to be this user's, and this user's alone.
"""

from __future__ import annotations

import hashlib
import logging
import os
import pickle
import shutil
import stat
import time
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import numba
import platformdirs
from filelock import FileLock
from numba.core.caching import _Cache
from numba.core.compiler import CompileResult

log = logging.getLogger(__name__)

_CHECKSUM_BYTES = 32
_UNUSED_AFTER = 60 * 24 * 3600.0


def compile_once(loop: Any, digest: str | None, example: tuple[Any, ...]) -> None:
    """Give a loop its machine code for arguments of the types of ``example``.

    It comes from the cache if it is there. If not, one process compiles while others that want the same
    wait for it. Where nothing can be kept, it is compiled for this process alone.

    Args:
        loop: What ``make_loop`` returned.
        digest: Of all that its machine code depends on, as :func:`acoexp.kernels.digest.digest_of` tells; None if
            that is not known.
        example: Arguments as the loop will get them.
    """
    if not hasattr(loop, "signatures"):  # NUMBA_DISABLE_JIT
        return
    typeof: Any = numba.typeof
    signature = tuple(typeof(argument) for argument in example)
    if signature in loop.overloads:
        return
    failed: dict[Any, Exception] = loop.__dict__.setdefault("failed", {})
    if signature in failed:  # the jobs of a sweep need not try it one after the other
        raise failed[signature]
    try:
        _compile_or_load(loop, digest, signature)
    except Exception as problem:
        failed[signature] = problem
        raise


def _compile_or_load(loop: Any, digest: str | None, signature: tuple[Any, ...]) -> None:
    folder = None if digest is None else usable_folder(digest)
    if folder is not None:
        loop._cache = KernelCache(folder)
        if loop._cache.file_of(signature).exists():
            loop.compile(signature)
            return
    with FileLock(folder / "lock") if folder is not None else nullcontext():
        if folder is None:
            log.info("compiling the colony, for this process alone")
        elif not loop._cache.file_of(signature).exists():
            log.info("compiling the colony, once for this machine")
        loop.compile(signature)


class KernelCache(_Cache):
    """Keeps compiled functions as files ``checksum + pickle``, one per signature, in a given folder."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    @property
    def cache_path(self) -> str:
        """The folder."""
        return str(self._folder)

    def file_of(self, signature: Any) -> Path:
        """Return the file for a signature, there or not."""
        return self._folder / hashlib.sha256(str(signature).encode()).hexdigest()

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """Return the compiled function, or None if it is not there or damaged."""
        file = self.file_of(sig)
        try:
            content = file.read_bytes() if is_ours(file) else b""
        except OSError:
            return None
        checksum, payload = content[:_CHECKSUM_BYTES], content[_CHECKSUM_BYTES:]
        if hashlib.sha256(payload).digest() != checksum:
            log.warning("a file of the kernel cache is damaged and is made anew")
            return None
        # numba itself would load all that it compiles by first, which takes a third of a second; machine code that
        # counts no references, as that of all kernels, needs nothing of it
        rebuild: Any = CompileResult._rebuild
        return rebuild(target_context, *pickle.loads(payload))

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep a compiled function; if that fails, say so and go on without."""
        if data.library.has_dynamic_globals:
            return
        payload = pickle.dumps(data._reduce())
        file = self.file_of(sig)
        draft = file.with_name(f"{file.name}.{os.getpid()}")
        try:
            draft.write_bytes(hashlib.sha256(payload).digest() + payload)
            draft.replace(file)
        except OSError as problem:
            log.warning("the kernel cache cannot be written: %s", problem)
            draft.unlink(missing_ok=True)

    def enable(self) -> None:
        """Do nothing: this cache is always on."""

    def disable(self) -> None:
        """Do nothing: this cache is always on."""

    def flush(self) -> None:
        """Do nothing: digests that are no longer asked for are pruned."""


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
