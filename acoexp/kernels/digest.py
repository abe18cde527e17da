"""Digests of code: what machine code depends on, and what a package's sources are."""

from __future__ import annotations

import hashlib
import os
import sys
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba

_NOT_OF_THE_CODE = {"NUMBA_NUM_THREADS"}
"""Settings of numba's that change no machine code; joblib gives its workers one."""


def digest_of(kernels: tuple[Any, ...]) -> str | None:
    """Return a digest of all that the machine code of these kernels, and constants among them, depends on.

    None if that can't be known: for a kernel made in a notebook, or inside a function.
    """
    parts = [sys.version, numba.__version__, llvmlite.__version__]
    parts += [llvmlite.binding.get_host_cpu_name(), llvmlite.binding.get_host_cpu_features().flatten()]
    said = {key: value for key, value in os.environ.items() if key.startswith("NUMBA_")}
    parts += sorted(f"{key}={value}" for key, value in said.items() if key not in _NOT_OF_THE_CODE)
    packages = {__name__.partition(".")[0]}
    for kernel in kernels:
        function = getattr(kernel, "py_func", kernel)
        if callable(function):
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
