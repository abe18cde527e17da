"""What a strategy costs for being a third party's: a built-in one against a copy of its file in another package.

One thread, everything that a trial costs included. Where arrays come to lie is worth up to a quarter, and whose
solver is made first decides it; so each order has a process of its own, and figures are geometric means of both.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from statistics import geometric_mean
from typing import Any

from rows import Given, Row
from timing import Timing, interleave

from acoexp.registry.load_map import as_grid
from acoexp.registry.parts import find_part
from acoexp.registry.resolve import resolve
from acoexp.testing.checks import ns_per_step
from acoexp.trial.solver import Solver

ROUNDS, AIM = 31, 1.03
PARTS = [("choice", "roulette"), ("diffusion", "gaussian"), ("update", "ant_cycle")]


def copied(owner: type, folder: Path) -> Any:
    """Return the same class from a copy of its file, a package of its own."""
    name = f"stranger_{owner.__name__.lower()}"
    (folder / name).mkdir()
    shutil.copy(str(sys.modules[owner.__module__].__file__), folder / name / "__init__.py")
    return getattr(import_module(name), owner.__name__)


def measure(group: str, name: str, rounds: int, first: str) -> Timing:
    """Return seconds per ant step, built-in and copied, where the ``first`` of the two is made first."""
    with tempfile.TemporaryDirectory() as folder:
        sys.path.insert(0, folder)
        choices = {"built-in": name, "copy": copied(find_part(group, name), Path(folder))()}
        order = sorted(choices, key=lambda which: which != first)
        solvers = {which: Solver(as_grid("env2"), resolve("pd", {group: choices[which]})) for which in order}
        return interleave(rounds, {which: lambda s=s: ns_per_step(s) / 1e9 for which, s in solvers.items()})


def rows(given: Given) -> Iterator[Row | str]:
    """Yield a row for each part."""
    for group, name in PARTS:
        found = []
        for first in ("built-in", "copy"):
            with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as alone:
                timing = alone.submit(measure, group, name, given.rounds or ROUNDS, first).result()
            found.append(timing.row("copy", "built-in", unit="ns", name=f"{group}={name} in another package"))
        value, ratio = (
            geometric_mean(values) for values in zip(*((r.value, r.compared) for r in found), strict=True)
        )
        yield replace(found[0], value=value, ratio=ratio, spread=max(row.spread for row in found), aim=AIM)
