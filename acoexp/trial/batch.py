"""A batch: trials of one configuration with many seeds, on all processors, handed over in portions.

What is held in memory is one portion and the table of features, so a batch may be as large as it likes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.trial.features import curve_of, prolonged
from acoexp.trial.outcome import Batch, Failure
from acoexp.trial.result import Result
from acoexp.trial.table import TABLE
from acoexp.trial.trials import Trials

PORTION = 2000
"""Trials that are handed over together at most."""
SECONDS = 2.0
"""Time after which finished trials are handed over, and so the most that is lost if the process is killed."""


Outcomes = Callable[[Result | Failure], None]
"""Called with what came of a trial, by one thread at a time."""


def run_batch(
    run: Callable[[Outcomes], None],
    iterations: int,
    keep: Callable[[Trials], None],
    *,
    found: Iterable[Trials] = (),
    show: Callable[[int], None] = lambda done: None,
) -> Batch:
    """Run a batch.

    Args:
        run: Runs its trials and hands over what came of each: a :meth:`~acoexp.trial.solver.Solver.run`.
        iterations: Cycles of a trial.
        keep: Called with each portion of finished trials, by one thread at a time.
        found: Trials of the same configuration that were found elsewhere, and count as finished here.
        show: Called now and then with the number of trials that are finished or failed.
    """
    collected = _Collected(keep, show, iterations)
    for portion in found:
        collected.add(portion)
    before = sum(map(len, collected.tables))
    began = time.perf_counter()
    try:
        run(collected.receive)
    finally:
        collected.hand_over()  # also what was finished before Ctrl-C
    seconds = time.perf_counter() - began
    table = np.sort(np.concatenate([np.zeros(0, TABLE), *collected.tables]), order="seed")
    return Batch(
        table, collected.curve.mean(), collected.best.mean(), collected.failures, len(table) - before, seconds
    )


class _Collected:
    """Finished trials: those not handed over yet, and the features of all."""

    def __init__(self, keep: Callable[[Trials], None], show: Callable[[int], None], iterations: int) -> None:
        self._keep, self._show = keep, show
        self._waiting: list[Result] = []
        self._handed_over = time.perf_counter()
        self.tables: list[NDArray[np.void]] = []
        self.failures: list[Failure] = []
        self.curve, self.best = _Mean(iterations), _Mean(iterations)

    def receive(self, outcome: Result | Failure) -> None:
        if isinstance(outcome, Failure):
            self.failures.append(outcome)
        else:
            self._waiting.append(outcome)
        if len(self._waiting) >= PORTION or time.perf_counter() - self._handed_over > SECONDS:
            self.hand_over()

    def hand_over(self) -> None:
        if self._waiting:
            waiting, self._waiting = self._waiting, []
            portion = Trials.of(waiting)
            self._keep(portion)
            self.add(portion)
        self._handed_over = time.perf_counter()
        self._show(sum(map(len, self.tables)) + len(self.failures))

    def add(self, portion: Trials) -> None:
        self.tables.append(portion.table)
        self.curve.add(portion.curve_pairs)
        self.best.add(portion.best_pairs)


class _Mean:
    """The mean of lengths in each cycle, of trials that are added one portion after the other."""

    def __init__(self, iterations: int) -> None:
        # whole numbers, so that the mean does not depend on the order in which threads finish
        self._moves, self._count = np.zeros((iterations, 2), np.int64), np.zeros(iterations, np.int64)

    def add(self, pairs: NDArray[Any]) -> None:
        """Add trials, int[n, cycles, 2], -1 where there is no length."""
        pairs = prolonged(pairs, len(self._count))
        self._moves += pairs.clip(min=0).sum(axis=0, dtype=np.int64)
        self._count += (pairs[:, :, 0] >= 0).sum(axis=0)

    def mean(self) -> NDArray[np.float64]:
        total = curve_of(self._moves)
        mean = np.full(total.shape, np.nan)
        np.divide(total, self._count, where=self._count > 0, out=mean)
        return mean
