"""A batch: the same trials one by one, in portions; what fails is told of and the rest goes on."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, solve
from acoexp.errors import StrategyError
from acoexp.registry.resolve import resolve
from acoexp.trial import batch
from acoexp.trial.batch import run_batch
from acoexp.trial.outcome import Batch
from acoexp.trial.result import Result
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SETTINGS: dict[str, Any] = {"iterations": 5, "ants": 2}


@pytest.fixture(scope="module")
def solver() -> Solver:
    """Return a solver of quick trials."""
    return Solver(YARD, resolve("aco", SETTINGS))


def batch_of(
    solver: Solver,
    seeds: Iterable[int],
    keep: Callable[[Trials], None],
    *,
    threads: int | None = None,
    **kept: Any,
) -> Batch:
    """Run a batch of a solver's trials."""
    iterations = solver.settings.scalars.iterations
    return run_batch(lambda receive: solver.run(seeds, receive, threads), iterations, keep, **kept)


@pytest.mark.parametrize("threads", [1, 3])
def test_its_table_is_that_of_the_trials_one_by_one(solver: Solver, threads: int) -> None:
    done = batch_of(solver, range(20), lambda portion: None, threads=threads)
    one_by_one = Trials.of([solve(YARD, "aco", seed, **SETTINGS) for seed in range(20)])
    assert done.table.tobytes() == one_by_one.table.tobytes()
    np.testing.assert_allclose(done.curve, np.nanmean(one_by_one.curves, axis=0))
    assert (done.ran, done.failures) == (20, [])


def test_it_is_handed_over_in_portions_each_trial_once(solver: Solver, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "PORTION", 6)
    portions: list[Trials] = []
    shown: list[int] = []
    batch_of(solver, range(20), portions.append, threads=2, show=shown.append)
    assert [len(portion) for portion in portions] == [6, 6, 6, 2]
    assert sorted(s for portion in portions for s in portion.seeds.tolist()) == list(range(20))
    assert shown == [6, 12, 18, 20]


def test_trials_that_are_found_count_and_are_not_handed_over(solver: Solver) -> None:
    whole = batch_of(solver, range(9), lambda portion: None)
    known = Trials.of([solve(YARD, "aco", seed, **SETTINGS) for seed in range(4)])
    portions: list[Trials] = []
    resumed = batch_of(solver, range(4, 9), portions.append, found=[known])
    assert resumed.table.tobytes() == whole.table.tobytes()
    assert resumed.curve.tobytes() == whole.curve.tobytes()
    assert resumed.ran == sum(map(len, portions)) == 5


def test_a_trial_that_fails_does_not_stop_the_others(solver: Solver, monkeypatch: pytest.MonkeyPatch) -> None:
    def trial(self: Solver, workspace: Any, seed: int, run: Any = Solver._trial) -> Result:
        if seed % 4 == 1:
            raise StrategyError(f"seed {seed} broke")
        result: Result = run(self, workspace, seed)
        return result

    monkeypatch.setattr(Solver, "_trial", trial)
    done = batch_of(solver, range(10), lambda portion: None, threads=2)
    assert done.table["seed"].tolist() == [0, 2, 3, 4, 6, 7, 8]
    assert sorted((failure.seed, str(failure.reason)) for failure in done.failures) == [
        (1, "seed 1 broke"), (5, "seed 5 broke"), (9, "seed 9 broke"),
    ]  # fmt: skip


def test_what_was_finished_before_an_interruption_is_handed_over(
    solver: Solver, monkeypatch: pytest.MonkeyPatch
) -> None:
    def seeds() -> Any:
        yield from range(7)
        raise KeyboardInterrupt

    portions: list[Trials] = []
    with pytest.raises(KeyboardInterrupt):
        batch_of(solver, seeds(), portions.append, threads=1)
    assert [portion.seeds.tolist() for portion in portions] == [list(range(7))]


def test_a_store_that_takes_no_portion_ends_it(solver: Solver, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "PORTION", 2)

    def keep(portion: Trials) -> None:
        raise OSError("disk full")

    with pytest.raises(OSError, match="disk full"):
        batch_of(solver, range(1000), keep, threads=2)
