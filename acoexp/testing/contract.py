"""The tests that hold for every part. Some run the part in a Python process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterable
from typing import Any, ClassVar

from acoexp.errors import AcoexpError
from acoexp.grid.grid import Grid
from acoexp.parameters import check_declarations, fields_of
from acoexp.testing.checks import (
    PLAIN,
    SEEDS,
    check_paths,
    cost,
    digest,
    everything,
    gone_twice,
    group_of,
    laid_astray,
    solvers,
)
from acoexp.trial.solver import Solver


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

    def test_no_ant_goes_where_it_has_been(self) -> None:
        """A choice leaves out cells that ``colony.untouched`` marks, and no other part marks or frees any."""
        for grid, solver in self._solvers():
            twice = gone_twice(solver, SEEDS[0])
            assert twice is None, (
                f"on {grid.name}: an ant went to {twice} twice; expected colony.untouched[cell] to be asked, "
                "as acoexp.colony.tabu.is_open does"
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
