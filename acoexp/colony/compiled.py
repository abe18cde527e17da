"""How kernels are compiled: one decorator for every function that runs inside a colony."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Function = TypeVar("Function", bound=Callable[..., Any])


def compiled(function: Function) -> Function:
    """Compile a function for use inside a colony: no GIL, IEEE arithmetic in the order written.

    Division by zero gives inf or nan as in NumPy instead of a check at every division. Nothing is compiled
    before the first call, and nothing at all under ``NUMBA_DISABLE_JIT=1``.
    """
    kernel: Function = numba.njit(nogil=True, error_model="numpy", forceinline=True, _nrt=False)(function)
    return kernel
