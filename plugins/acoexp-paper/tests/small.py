"""How small the tests' report is, and what it is written with."""

from __future__ import annotations

from pathlib import Path

from acoexp_paper.experiment import builtin_map

from acoexp.report.context import Context
from acoexp.settings import resolve

OWN = {"iterations": 12, "ants": 5}
TRIALS, ENSEMBLE_TRIALS, MAPS = 20, 10, 2


def context(folder: Path) -> Context:
    """Return a context with fewer cycles and ants than the paper's, and no store."""
    return Context("pdg", resolve("pdg", OWN), builtin_map("fig13"), folder)
