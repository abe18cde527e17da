"""How kernels are compiled: one decorator for every function that runs inside a colony."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Function = TypeVar("Function", bound=Callable[..., Any])

_OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "forceinline": True,
    "_nrt": False,
    "no_cfunc_wrapper": True,  # a tenth of the time to compile; nothing calls a kernel from C
}


def compiled(function: Function) -> Function:
    """Compile a function for use inside a colony.

    It is inlined into the loop, holds no GIL, counts no references to its arrays (three times as fast; it can
    allocate nothing, then), and divides by zero as NumPy does. Nothing is compiled before the first call, and
    nothing at all under ``NUMBA_DISABLE_JIT=1``.
    """
    kernel: Function = numba.njit(**_OPTIONS)(function)
    return kernel


def is_compiled(function: Any) -> bool:
    """Tell whether a function is one of :func:`compiled`; under ``NUMBA_DISABLE_JIT`` nobody can, and all are."""
    config: Any = numba.config
    if config.DISABLE_JIT:
        return callable(function)
    options = getattr(function, "targetoptions", {})
    return all(options.get(key) == value for key, value in _OPTIONS.items())
