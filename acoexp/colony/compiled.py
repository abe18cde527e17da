"""How kernels are compiled: one decorator for all that runs inside a colony, and one for the colony."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any, TypeVar

import numba
from numba.core.registry import CPUDispatcher

Function = TypeVar("Function", bound=Callable[..., Any])

_OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "forceinline": True,
    "_nrt": False,
    "no_cfunc_wrapper": True,  # a tenth of the time to compile; nothing calls a kernel from C
}


class Inlined(CPUDispatcher):
    """A function for compiled code to call, made in half the time, as nothing is made for calls from Python.

    Called from Python all the same, as tests do, it is compiled once more, for that.
    """

    @cached_property
    def from_python(self) -> Any:
        """The same function for callers in Python."""
        return numba.njit(**_OPTIONS)(self.py_func)

    def __call__(self, *arguments: Any) -> Any:
        """Call it from Python."""
        return self.from_python(*arguments)


def compiled(function: Function) -> Function:
    """Compile a function for use inside a colony.

    It is inlined into the loop, holds no GIL, counts no references to its arrays (three times as fast; it can
    allocate nothing, then), and divides by zero as NumPy does. Nothing is compiled before the first call, and
    nothing at all under ``NUMBA_DISABLE_JIT=1``.
    """
    config: Any = numba.config
    if config.DISABLE_JIT:
        return function
    options: Any = compiled_for_python(function)
    kernel: Any = Inlined(function, targetoptions={**options.targetoptions, "no_cpython_wrapper": True})
    return kernel  # type: ignore[no-any-return]


def compiled_for_python(function: Function) -> Function:
    """Compile a function in the same way that is called from Python: a whole trial, not a step of it."""
    entry: Function = numba.njit(**_OPTIONS)(function)
    return entry


def is_compiled(function: Any) -> bool:
    """Tell whether a function is one of :func:`compiled`; under ``NUMBA_DISABLE_JIT`` nobody can, and all are."""
    config: Any = numba.config
    return callable(function) if config.DISABLE_JIT else isinstance(function, Inlined)
