"""How small the tests' report is, what it is written with, and what it consists of."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from acoexp_paper.published.tables import ENVIRONMENTS

from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.runs.batch import kept_trials
from acoexp.tracking.tracker import NoTracker
from acoexp.trial.trials import Trials

OWN = {"iterations": 12, "ants": 5}
TRIALS, ENSEMBLE_TRIALS, READING_TRIALS, MAPS = 20, 10, 8, 2

FIGURES = [
    *(f"fig{number:02}" for number in (1, *range(7, 19))),
    *(f"maps_{env}" for env in ENVIRONMENTS),
]
TABLES = [
    "verdicts",
    "comparisons",
    "printed",
    "spread",
    "table1",
    "table2",
    "table3",
    "averages",
    "success",
    "sources",
    "readings",
    "reading_claims",
    "audit",
    "maps",
    "fits",
    "provenance",
]
"""The names of their files, in their order."""

run_trials = partial(kept_trials, tracker=NoTracker())


def context(folder: Path, trials_of: Callable[..., Trials] = run_trials) -> Context:
    """Return a context with fewer cycles and ants than the paper's, and no store."""
    return Context(
        algo="pdg",
        preset=resolve("pdg", {}),
        settings=resolve("pdg", OWN),
        grid=load_map("fig13"),
        folder=folder,
        trials_of=trials_of,
    )
