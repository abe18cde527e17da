"""The kernel cache: a colony is compiled once per machine, and never runs code that has been edited since.

numba's own cache looks at one file's time stamp and cannot keep closures. This one keeps a file per signature
in a folder per digest, and the digest covers everything that the machine code depends on: Python, numba, the
processor, and every source file of acoexp's and of each part's own top-level package. It stands on numba's
``_Cache`` interface, which is semi-private: pyproject.toml pins numba's minor version.
"""

from __future__ import annotations

import hashlib
import logging
import os
import pickle
import shutil
import sys
import time
from contextlib import nullcontext
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba
import platformdirs
from filelock import FileLock
from numba.core.caching import _Cache
from numba.core.compiler import CompileResult

log = logging.getLogger(__name__)

_UNUSED_AFTER = 60 * 24 * 3600.0
_CHECKSUM_BYTES = 32
_NOT_OF_THE_CODE = {"NUMBA_NUM_THREADS"}
"""Settings of numba's that change no machine code; joblib gives its workers one."""

_failed: dict[tuple[Any, Any], Exception] = {}
"""Why a loop cannot be compiled: the jobs of a sweep need not try it one after the other."""


def compile_once(loop: Any, kernels: tuple[Any, ...], example: tuple[Any, ...]) -> None:
    """Give a loop its machine code for arguments of the types of ``example``.

    It comes from the cache if it is there. If not, one process compiles while others that want the same
    wait for it. Where nothing can be kept, it is compiled for this process alone.

    Args:
        loop: What ``make_loop`` returned.
        kernels: The kernels that it closes over; None for one that is left out.
        example: Arguments as the loop will get them.
    """
    if not hasattr(loop, "signatures"):  # NUMBA_DISABLE_JIT
        return
    typeof: Any = numba.typeof
    signature = tuple(typeof(argument) for argument in example)
    if signature in loop.overloads:
        return
    if (loop, signature) in _failed:
        raise _failed[loop, signature]
    try:
        _compile_or_load(loop, kernels, signature)
    except Exception as problem:
        _failed[loop, signature] = problem
        raise


def _compile_or_load(loop: Any, kernels: tuple[Any, ...], signature: tuple[Any, ...]) -> None:
    folder = _usable_folder(kernels)
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
            content = file.read_bytes()
        except OSError:
            return None
        checksum, payload = content[:_CHECKSUM_BYTES], content[_CHECKSUM_BYTES:]
        if hashlib.sha256(payload).digest() != checksum:
            log.warning("a file of the kernel cache is damaged and is made anew")
            return None
        target_context.refresh()
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


def _usable_folder(kernels: tuple[Any, ...]) -> Path | None:
    """Return the folder for these kernels, made if need be; None if they can't be kept."""
    digest = digest_of(kernels)
    if digest is None:
        return None
    folder = cache_root() / digest
    try:
        folder.mkdir(parents=True, exist_ok=True)
        os.utime(folder)
        if not (folder / "lock").exists():
            _prune(folder.parent)
            (folder / "lock").touch()
    except OSError as problem:
        log.warning("the kernel cache cannot be used, so every process compiles for itself: %s", problem)
        return None
    return folder


def digest_of(kernels: tuple[Any, ...]) -> str | None:
    """Return a digest of all that the machine code of these kernels depends on.

    None if that can't be known: for a kernel made in a notebook, or inside a function.
    """
    parts = [sys.version, numba.__version__, llvmlite.__version__]
    parts += [llvmlite.binding.get_host_cpu_name(), llvmlite.binding.get_host_cpu_features().flatten()]
    said = {key: value for key, value in os.environ.items() if key.startswith("NUMBA_")}
    parts += sorted(f"{key}={value}" for key, value in said.items() if key not in _NOT_OF_THE_CODE)
    packages = {__name__.partition(".")[0]}
    for kernel in kernels:
        function = getattr(kernel, "py_func", kernel)
        if function is not None:
            if function.__module__ == "__main__" or function.__closure__ or "<" in function.__qualname__:
                return None
            packages.add(function.__module__.partition(".")[0])
            function = f"{function.__module__}:{function.__qualname__}"
        parts.append(str(function))
    sources = [digest_of_sources(package) for package in sorted(packages)]
    if None in sources:
        return None
    return hashlib.sha256(repr((parts, sources)).encode()).hexdigest()[:32]


@cache
def digest_of_sources(package: str, only: tuple[str, ...] | None = None) -> str | None:
    """Return a digest of the source files of a top-level package, as they are when first asked for.

    Args:
        package: Its name; None comes back if it is not imported, or has no files.
        only: Folders and files at its top that count; all of them by default.
    """
    if package not in sys.modules:
        return None
    module = sys.modules[package]
    folders = [Path(folder) for folder in getattr(module, "__path__", [])]
    files = [(f.relative_to(folder), f) for folder in folders for f in folder.rglob("*.py")]
    files = [(name, f) for name, f in files if only is None or name.parts[0] in only]
    if not folders:
        if getattr(module, "__file__", None) is None:
            return None
        files = [(Path(package), Path(str(module.__file__)))]
    digest = hashlib.sha256()
    for name, file in sorted(files):
        digest.update(f"{name}\0".encode() + file.read_bytes() + b"\0")
    return digest.hexdigest()


def _prune(root: Path) -> None:
    """Remove what has not been asked for in sixty days."""
    for folder in root.iterdir():
        if time.time() - folder.stat().st_mtime > _UNUSED_AFTER:
            shutil.rmtree(folder, ignore_errors=True)
