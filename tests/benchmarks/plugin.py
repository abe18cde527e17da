"""What a strategy costs for being a third party's: a built-in one against a copy of its file in another package.

    python tests/benchmarks/plugin.py [ROUNDS]

Interleaved, one thread, everything that a trial costs included. Where arrays come to lie is worth up to a
quarter, and whose solver is made first decides it; so each order has a process of its own, and the ratio is the
geometric mean of both. At most 1.03 is aimed at. Run it on an idle machine.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from statistics import geometric_mean, median
from typing import Any

from acoexp.registry.load_map import as_grid
from acoexp.registry.parts import find_part
from acoexp.registry.resolve import resolve
from acoexp.testing.checks import ns_per_step
from acoexp.trial.solver import Solver

PARTS = [("choice", "roulette"), ("diffusion", "gaussian"), ("update", "ant_cycle")]


def copied(owner: type, folder: Path) -> Any:
    """Return the same class from a copy of its file, a package of its own."""
    name = f"stranger_{owner.__name__.lower()}"
    (folder / name).mkdir()
    shutil.copy(str(sys.modules[owner.__module__].__file__), folder / name / "__init__.py")
    return getattr(import_module(name), owner.__name__)


def measure(group: str, name: str, rounds: int, first: str) -> tuple[float, float]:
    """Return ns per ant step, built-in and copied, where the ``first`` of the two is made first."""
    with tempfile.TemporaryDirectory() as folder:
        sys.path.insert(0, folder)
        choices = {"built-in": name, "copy": copied(find_part(group, name), Path(folder))()}
        order = sorted(choices, key=lambda which: which != first)
        solvers = {which: Solver(as_grid("env2"), resolve("pd", {group: choices[which]})) for which in order}
        times: dict[str, list[float]] = {which: [] for which in order}
        for _ in range(rounds):
            for which in order:
                times[which].append(ns_per_step(solvers[which]))
    return median(times["built-in"]), median(times["copy"])


def main(rounds: int) -> None:
    print(f"{'part':<20}{'built-in':>10}{'copy':>10}  ns per ant step{'ratio':>10}")
    for group, name in PARTS:
        found = []
        for first in ("built-in", "copy"):
            with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as alone:
                found.append(alone.submit(measure, group, name, rounds, first).result())
        built_in, copy = (geometric_mean(column) for column in zip(*found, strict=True))
        print(f"{f'{group}={name}':<20}{built_in:>10.1f}{copy:>10.1f}{'':17}{copy / built_in:>10.3f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 31)
