"""The contract's tests, for the author of a part to run over it with pytest:

    from acoexp.testing import StrategyContract
    from my_package.shy import Shy

    class TestShy(StrategyContract):
        part = Shy()

Some run the part in a Python process of its own, as ``python -m acoexp.testing module:Class`` with its
parameters, a preset and further settings, each as JSON; that prints a digest of all that the part did.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterable
from importlib import import_module
from statistics import median
from typing import Any, ClassVar

import numpy as np

from acoexp.api import as_grid
from acoexp.errors import AcoexpError
from acoexp.grid import MOVE_RULES, Grid
from acoexp.parameters import build, check_declarations, fields_of
from acoexp.registry import STRATEGIES
from acoexp.result import Result
from acoexp.settings import resolve
from acoexp.solver import Solver

PLAIN = {
    "heuristic": "goal_distance",
    "choice": "roulette",
    "diffusion": "none",
    "post": "none",
    "update": "ant_cycle",
}
"""The part of each group that a part's cost is measured against."""

SEEDS = range(3)
FEW: dict[str, Any] = {"ants": 4, "iterations": 10}
ROUNDS, TRIALS = 7, 20


class StrategyContract:
    """Tests that hold for every part.

    Attributes:
        part: The part, an object of a class that can be imported.
        algo: The preset whose part it takes the place of.
        settings: Further settings, as for :func:`acoexp.solve`, that JSON can hold.
    """

    part: ClassVar[Any]
    algo: ClassVar[str] = "aco"
    settings: ClassVar[dict[str, Any]] = {}
    _out_of_bounds: ClassVar[bool] = False

    def test_nothing_is_read_or_written_out_of_bounds(self) -> None:
        """With numba's checks of every index; in another process, and first, as it might end this one."""
        self._skip_if_it_cannot_run()
        type(self)._out_of_bounds = True
        checked = self._elsewhere(NUMBA_BOUNDSCHECK="1", NUMBA_DISABLE_JIT="0")
        type(self)._out_of_bounds = False
        assert checked == self._here()

    def test_it_compiles_and_finds_valid_paths(self) -> None:
        """On several maps, under every rule, paths are made of allowed moves and none beats the optimum."""
        self._skip_if_out_of_bounds()
        check_declarations(type(self.part))
        found = 0
        for grid, solver in solvers(self.part, self.algo, self.settings):
            for result in solver.solve_many(SEEDS, threads=1):
                found += check_paths(grid, result)
        assert found > 0, "expected an ant to arrive on at least one of the maps; all were lost in every trial"

    def test_a_trial_depends_on_its_seed_alone(self) -> None:
        """One by one, in a batch, in another order or on several threads: always the same."""
        for grid, solver in self._solvers():
            single = [everything(solver.solve(seed)) for seed in SEEDS]
            for threads in (1, 3):
                batch = [everything(result) for result in solver.solve_many([*SEEDS, *SEEDS], threads=threads)]
                assert batch == single * 2, f"on {grid.name}, {threads} threads: other results than one by one"

    def test_pheromone_is_laid_on_allowed_moves_alone(self) -> None:
        """Elsewhere it would do nothing, so it would be lost; edges there that began alike stay alike."""
        for grid, solver in self._solvers():
            astray = laid_astray(solver, SEEDS[0])
            assert not astray, (
                f"on {grid.name}: pheromone was changed on {len(astray)} moves that are not allowed, such as "
                f"{astray[0]}; expected colony.allowed[cell] >> direction & 1 to be asked first"
            )

    def test_without_the_compiler_it_does_the_same(self) -> None:
        """As plain Python, under NUMBA_DISABLE_JIT."""
        here = self._here()
        assert self._elsewhere(NUMBA_DISABLE_JIT="1") == here

    def test_cost_per_ant_step(self, record_property: Callable[[str, object], None]) -> None:
        """Measured, printed (``pytest -s``) and put into pytest's report; no cost is too high."""
        self._skip_if_it_cannot_run()
        group = group_of(self.part)
        own, plain, ratio = cost(self.algo, {**self.settings, group: self.part}, group)
        record_property("ns_per_ant_step", own)
        record_property("ratio_to_plain", ratio)
        print(
            f"\n{type(self.part).__name__}: {own:.1f} ns per ant step, {ratio:.2f} times {group}={PLAIN[group]} "
            f"({plain:.1f} ns)"
        )

    def _solvers(self) -> Iterable[tuple[Grid, Solver]]:
        self._skip_if_it_cannot_run()
        return solvers(self.part, self.algo, self.settings)

    def _here(self) -> str:
        self._skip_if_it_cannot_run()
        return digest(self.part, self.algo, self.settings)

    def _skip_if_it_cannot_run(self) -> None:
        """Skip a test that would only say once more what another does: the part cannot run at all."""
        import pytest

        self._skip_if_out_of_bounds()
        try:
            next(iter(solvers(self.part, self.algo, self.settings)))
        except AcoexpError:
            pytest.skip("the part cannot run at all: see test_it_compiles_and_finds_valid_paths")

    def _skip_if_out_of_bounds(self) -> None:
        import pytest

        if self._out_of_bounds:
            pytest.skip("the part reads or writes out of bounds, which might end this process")

    def _elsewhere(self, **variables: str) -> str:
        """Return the digest that another process prints."""
        owner = type(self.part)
        importable = owner.__module__ != "__main__" and "<" not in owner.__qualname__
        assert importable, f"expected {owner.__qualname__} at the top of a module, where it can be imported"
        parameters = {name: getattr(self.part, name) for name in fields_of(owner)}
        arguments = (
            f"{owner.__module__}:{owner.__qualname__}",
            *map(json.dumps, (parameters, self.algo, self.settings)),
        )
        paths = os.pathsep.join(path or os.getcwd() for path in sys.path)  # noqa: PTH109
        done = subprocess.run(
            [sys.executable, "-m", "acoexp.testing", *arguments],
            env={**os.environ, "PYTHONPATH": paths, **variables},
            capture_output=True,
            text=True,
            check=False,
        )
        reason = (done.stderr.strip().splitlines() or ["nothing was said"])[-1]
        assert done.returncode == 0, f"under {' '.join(f'{k}={v}' for k, v in variables.items())}: {reason}"
        return done.stdout.strip()


def maps() -> list[Grid]:
    """Return an open map, and one with obstacles at random under each rule for diagonals."""
    grids = [Grid(np.zeros((7, 9)), name="open")]
    draw = np.random.default_rng(0)
    for rule in MOVE_RULES:
        obstacles = draw.random((12, 15)) < 0.2
        obstacles[0, :] = obstacles[:, -1] = False  # so there is a way
        grids.append(Grid(obstacles, moves=rule, name=f"random, {rule}"))
    return grids


def solvers(part: Any, algo: str, settings: dict[str, Any]) -> Iterable[tuple[Grid, Solver]]:
    """Yield each map with a solver that has the part."""
    resolved = resolve(algo, {**FEW, **settings, group_of(part): part})
    for grid in maps():
        yield grid, Solver(grid, resolved)


def group_of(part: Any) -> str:
    """Return the group that a part belongs to."""
    return next(group for group, kind in STRATEGIES.items() if isinstance(part, kind))


def check_paths(grid: Grid, result: Result) -> bool:
    """Check the paths of a trial move by move; return whether there is one."""
    if result.path is None:
        return False
    assert grid.measure(result.path) == result.l1_pair, f"on {grid.name}: a path and its length differ"
    assert result.length >= grid.optimum, f"on {grid.name}: a path of {result.length}, optimum {grid.optimum}"
    if result.raw_path is not None:
        grid.measure(result.raw_path)
    return True


def laid_astray(solver: Solver, seed: int) -> list[str]:
    """Return the moves that are not allowed whose pheromone a trial changed, as texts.

    Known by that they are unlike the others that began alike; evaporation and limits are the same for all.
    """
    workspace = solver._new_workspace(np.zeros(1, dtype=np.uint8))
    solver._trial(workspace, seed)
    colony, problem = workspace.colony, solver._problem
    closed = np.flatnonzero(~problem.per_edge(problem.allowed_edges(), border=False))
    began = np.broadcast_to(solver._prepared.initial, colony.stored.shape)[closed]
    astray: list[str] = []
    for level in np.unique(began):
        edges = closed[began == level]
        levels, counts = np.unique(colony.stored[edges], return_counts=True)
        for edge in edges[colony.stored[edges] != levels[counts.argmax()]]:
            row, col = divmod(int(edge) // 8, int(colony.width))
            astray.append(f"direction {edge % 8} from ({row - 1}, {col - 1})")
    return astray


def everything(result: Result) -> str:
    """Return all that a trial leaves behind, as one text to be compared."""
    return json.dumps(result.as_dict())


def digest(part: Any, algo: str, settings: dict[str, Any]) -> str:
    """Return a digest of all that the part's trials leave behind."""
    found = [everything(solver.solve(seed)) for _, solver in solvers(part, algo, settings) for seed in SEEDS]
    return hashlib.sha256("\n".join(found).encode()).hexdigest()


def cost(algo: str, settings: dict[str, Any], group: str) -> tuple[float, float, float]:
    """Return ns per ant step with a part, with its group's plain one, and the ratio: medians, interleaved."""
    chosen: tuple[dict[str, Any], ...] = settings, {**settings, group: PLAIN[group]}
    ready = [Solver(as_grid("env2"), resolve(algo, each)) for each in chosen]
    times = [[ns_per_step(solver) for solver in ready] for _ in range(ROUNDS)]
    own, plain = (median(column) for column in zip(*times, strict=True))
    return own, plain, median(a / b for a, b in times)


def ns_per_step(solver: Solver) -> float:
    """Return ns per ant step, everything that a trial costs included."""
    began = time.perf_counter_ns()
    results = solver.solve_many(range(TRIALS), threads=1)
    return (time.perf_counter_ns() - began) / sum(result.ant_steps for result in results)


def main(where: str, parameters: str, algo: str, settings: str) -> None:
    """Print the digest of a part that is named by module and class."""
    module, _, name = where.partition(":")
    part = build(getattr(import_module(module), name), json.loads(parameters))
    print(digest(part, json.loads(algo), json.loads(settings)))


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except AcoexpError as problem:
        sys.exit(str(problem))
