"""A batch: trials of one configuration with many seeds, on all processors, handed over in portions.

What is held in memory is one portion and the table of features, so a batch may be as large as it likes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.trial.failures import Failure
from acoexp.trial.features import curve_of
from acoexp.trial.result import Result
from acoexp.trial.table import TABLE
from acoexp.trial.trials import Trials

PORTION = 2000
"""Trials that are handed over together at most."""
SECONDS = 2.0
"""Time after which finished trials are handed over, and so the most that is lost if the process is killed."""


class Batch(NamedTuple):
    """What a batch found.

    Attributes:
        table: Features of type ``TABLE``, one row for each finished trial, in the order of the seeds.
        curve: Mean of the best length found in each cycle, float[iterations], over the trials in which an ant
            arrived in it; nan where none did in any.
        failures: The trials that came to no result.
        ran: How many trials were run to their end, besides those that were found.
        seconds: Time that these took together.
    """

    table: NDArray[np.void]
    curve: NDArray[np.float64]
    failures: list[Failure]
    ran: int
    seconds: float


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
    return Batch(table, collected.mean_curve(), collected.failures, len(table) - before, seconds)


class _Collected:
    """Finished trials: those not handed over yet, and the features of all."""

    def __init__(self, keep: Callable[[Trials], None], show: Callable[[int], None], iterations: int) -> None:
        self._keep, self._show = keep, show
        self._waiting: list[Result] = []
        self._handed_over = time.perf_counter()
        self.tables: list[NDArray[np.void]] = []
        self.failures: list[Failure] = []
        # whole numbers, so that the mean does not depend on the order in which threads finish
        self._moves, self._count = np.zeros((iterations, 2), np.int64), np.zeros(iterations, np.int64)

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
        self._moves += portion.curve_pairs.clip(min=0).sum(axis=0, dtype=np.int64)
        self._count += (portion.curve_pairs[:, :, 0] >= 0).sum(axis=0)

    def mean_curve(self) -> NDArray[np.float64]:
        total = curve_of(self._moves)
        mean = np.full(total.shape, np.nan)
        np.divide(total, self._count, where=self._count > 0, out=mean)
        return mean
