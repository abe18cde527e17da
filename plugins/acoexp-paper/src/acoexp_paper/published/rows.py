"""What the paper's own ten trials say of the measures and events that its claims are about."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from acoexp_paper.published import tables
from acoexp_paper.published.tables import ENVIRONMENTS, TABLES

_TABLE_OF = {env: table for table, env in TABLES.items()}

Measured = NDArray[np.float64] | None
Happened = NDArray[np.bool_] | None


def _column(env: str, algo: str, name: str) -> Measured:
    """Return a printed column without misprints, float64[10]; None where the paper has no rows."""
    if env not in _TABLE_OF or algo not in tables.ALGOS:
        return None
    return tables.mended(_TABLE_OF[env], algo, name)


def _is_optimum(env: str, algo: str, name: str) -> Happened:
    lengths = _column(env, algo, name)
    return None if lengths is None else lengths == round(ENVIRONMENTS[env].optimum, 4)


def _hitting_time(env: str, algo: str) -> Measured:
    x1, found = _column(env, algo, "x1"), _is_optimum(env, algo, "l1")
    return None if x1 is None or found is None else np.where(found, x1, np.inf)


def _waiting(env: str, algo: str) -> Measured:
    x1, x2 = _column(env, algo, "x1"), _column(env, algo, "x2")
    return None if x1 is None or x2 is None else x2 - x1


def _stuck(env: str, algo: str) -> Happened:
    kept = _is_optimum(env, algo, "l2")
    return None if kept is None else ~kept


def _steady(env: str, algo: str) -> Happened:
    x1, x2, x3 = (_column(env, algo, name) for name in ("x1", "x2", "x3"))
    return None if x1 is None else (x1 == x2) & (x2 == x3)


PRINTED_MEASURES: dict[str, Callable[[str, str], Measured]] = {
    "hitting time": _hitting_time,
    "l2": lambda env, algo: _column(env, algo, "l2"),
    "x2 - x1": _waiting,
    "x3": lambda env, algo: _column(env, algo, "x3"),
}
"""By measure: of an environment and an algorithm, float64[10]; a trial that misses the optimum is behind all."""

PRINTED_EVENTS: dict[str, Callable[[str, str], Happened]] = {
    "found": lambda env, algo: _is_optimum(env, algo, "l1"),
    "converged": lambda env, algo: _is_optimum(env, algo, "l2"),
    "stuck": _stuck,
    "steady": _steady,
}
"""By event: of an environment and an algorithm, bool[10]."""
