"""A batch: trials of one configuration with many seeds, on all processors, handed over in portions.

What is held in memory is one portion and the table of features, so a batch may be as large as it likes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.grid import path_length
from acoexp.result import Result
from acoexp.solver import Failure, Solver
from acoexp.trials import TABLE, Trials

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
        ran: How many trials were run to their end, besides those that were there.
        seconds: Time that these took together.
    """

    table: NDArray[np.void]
    curve: NDArray[np.float64]
    failures: list[Failure]
    ran: int
    seconds: float


def run_batch(
    solver: Solver,
    seeds: Iterable[int],
    keep: Callable[[Trials], None],
    *,
    threads: int | None = None,
    there: Iterable[Trials] = (),
    tell: Callable[[int], None] = lambda done: None,
) -> Batch:
    """Run a batch.

    Args:
        solver: Runs the trials.
        seeds: The seeds to run.
        keep: Called with each portion of finished trials, by one thread at a time.
        threads: How many threads; by default one for each processor.
        there: Trials of the same cell that were found elsewhere, and count as finished here.
        tell: Called now and then with the number of trials that are finished or failed.

    Raises:
        SettingsError: for a number of threads that is not one.
    """
    collected = _Collected(keep, tell, solver.settings.scalars.iterations)
    for portion in there:
        collected.add(portion)
    found = sum(map(len, collected.tables))
    began = time.perf_counter()
    try:
        solver.run(seeds, collected.receive, threads)
    finally:
        collected.hand_over()  # also what was finished before Ctrl-C
    seconds = time.perf_counter() - began
    table = np.sort(np.concatenate([np.zeros(0, TABLE), *collected.tables]), order="seed")
    return Batch(table, collected.mean_curve(), collected.failures, len(table) - found, seconds)


class _Collected:
    """Finished trials: those not handed over yet, and the features of all."""

    def __init__(self, keep: Callable[[Trials], None], tell: Callable[[int], None], iterations: int) -> None:
        self._keep, self._tell = keep, tell
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
        self._tell(sum(map(len, self.tables)) + len(self.failures))

    def add(self, portion: Trials) -> None:
        self.tables.append(portion.table)
        self._moves += portion.curve_pairs.clip(min=0).sum(axis=0, dtype=np.int64)
        self._count += (portion.curve_pairs[:, :, 0] >= 0).sum(axis=0)

    def mean_curve(self) -> NDArray[np.float64]:
        straight, diagonal = self._moves.T.astype(np.float64)
        total = path_length(straight, diagonal)
        mean = np.full(total.shape, np.nan)
        np.divide(total, self._count, where=self._count > 0, out=mean)
        return mean
