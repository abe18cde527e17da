"""How many threads run a batch."""

from __future__ import annotations

import os

import numpy as np

from acoexp.errors import SettingsError, shown

MOST_THREADS = 4096
"""Threads at most: far more than there are processors, and fewer than a system refuses."""


def check_threads(threads: int | None) -> int:
    """Return a number of threads; where none is given, one for each processor that this process may use.

    Raises:
        SettingsError: if it is no whole number from 1 to ``MOST_THREADS``.
    """
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    whole = isinstance(threads, int | np.integer) and not isinstance(threads, bool)
    if not whole or not 1 <= threads <= MOST_THREADS:
        raise SettingsError(f"threads: expected a whole number from 1 to {MOST_THREADS}; got {shown(threads)}")
    return int(threads)
