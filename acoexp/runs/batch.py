"""A batch that is kept: what the store already has is taken from there, the rest is run, and all is one run."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.tracking.setup import Artifacts, Setup
from acoexp.tracking.tracker import Tracker
from acoexp.trial.batch import run_batch
from acoexp.trial.outcome import Batch
from acoexp.trial.result import Result
from acoexp.trial.seeds import Seeds
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

log = logging.getLogger(__name__)


def keep_batch(
    setup: Setup,
    seeds: Seeds,
    tracker: Tracker,
    *,
    threads: int | None = None,
    resume: bool = True,
    artifacts: Callable[[Result], Artifacts] = lambda result: {},
    receive: Callable[[Trials], None] = lambda portion: None,
    show: Callable[[int], None] = lambda done: None,
) -> Batch:
    """Run what is missing of a batch and keep it.

    Args:
        setup: What its trials are of.
        seeds: Their seeds.
        tracker: Where they are kept.
        threads: How many threads; by default one for each processor.
        resume: Whether trials that the tracker has are taken from there; otherwise all are run, and the new run
            takes the old one's place.
        artifacts: Returns what the run carries of the best trial: the first of those with the shortest path.
        receive: Called with each portion of trials, those that were found and those that were run.
        show: Called now and then with the number of trials that are finished or failed.

    Raises:
        SettingsError: for a number of threads that is not one.
        StrategyError: if the colony cannot be made. A trial that fails is in the batch's ``failures``.
        TrackingError: if the batch cannot be kept.
    """
    kept = _KeptBatch(setup, seeds, tracker, resume, receive)
    try:
        solver = Solver(setup.grid, setup.settings)
        batch = run_batch(
            lambda receive: solver.run(kept.missing(), receive, threads),
            setup.settings.scalars.iterations,
            kept.keep,
            found=kept.found_before(),
            show=show,
        )
        kept.finish(batch, lambda: _of_best(batch, solver, artifacts))
    except BaseException as problem:
        kept.abandon(str(problem) or type(problem).__name__)
        raise
    return batch


def kept_trials(
    settings: Settings,
    grid: Grid,
    seeds: Seeds,
    show: Callable[[int], None] = lambda done: None,
    *,
    tracker: Tracker,
    threads: int | None = None,
    resume: bool = True,
    artifacts: Callable[[Result], Artifacts] = lambda result: {},
) -> Trials:
    """Return the trials of a batch, in the order of their seeds; see :func:`keep_batch`.

    Raises:
        StrategyError: if a trial failed.
    """
    portions: list[Trials] = []
    batch = keep_batch(
        Setup.of(settings, grid),
        seeds,
        tracker,
        threads=threads,
        resume=resume,
        artifacts=artifacts,
        receive=portions.append,
        show=show,
    )
    for failure in batch.failures:
        raise failure.reason
    return Trials.joined(portions)


class _KeptBatch:
    """A batch, and the run that it is kept as: none if the store has it with all of its trials."""

    def __init__(
        self, setup: Setup, seeds: Seeds, tracker: Tracker, resume: bool, receive: Callable[[Trials], None]
    ) -> None:
        self._setup, self._seeds, self._tracker, self._receive = setup, seeds, tracker, receive
        self._resume = resume
        self._found: list[NDArray[np.uint64]] = []
        known = resume and tracker.has(setup.identity(seeds))
        self._run = None if known else tracker.begin(setup, seeds, resume=resume)

    def found_before(self) -> Iterator[Trials]:
        """Yield the trials that the store has, each kept once more as one of this run."""
        for portion in self._in_store():
            self._found.append(portion.seeds)
            self.keep(portion)
            yield portion
        total = sum(map(len, self._found))
        if self._found:
            log.info("%s: %d of %d trials found in the store", _name(self._setup), total, len(self._seeds))
        if self._run is None and total < len(self._seeds):
            self._keep_again()

    def missing(self) -> Iterator[int]:
        """Yield the seeds that were not found; nothing is looked at before the first is asked for."""
        found = self._found
        yield from np.setdiff1d(self._seeds.array(), np.concatenate(found)).tolist() if found else self._seeds

    def keep(self, portion: Trials) -> None:
        if self._run is not None:
            self._run.keep(portion)
        self._receive(portion)

    def finish(self, batch: Batch, artifacts: Callable[[], Artifacts]) -> None:
        """Keep the aggregates and the table of all trials, and end the run."""
        if self._run is not None:
            self._run.finish(batch, artifacts())

    def abandon(self, reason: str) -> None:
        if self._run is not None:
            self._run.abandon(reason)

    def _in_store(self) -> Iterable[Trials]:
        return self._tracker.find_trials(self._setup.configuration_id, self._seeds) if self._resume else ()

    def _keep_again(self) -> None:
        """Begin a run in place of a finished one whose trials are damaged or gone."""
        log.warning("%s: trials of a finished batch are lost; they are run and kept again", _name(self._setup))
        self._run = self._tracker.begin(self._setup, self._seeds, resume=False)
        for portion in self._in_store():
            self._run.keep(portion)


def _of_best(batch: Batch, solver: Solver, artifacts: Callable[[Result], Artifacts]) -> Artifacts:
    """Return the artifacts of the best trial, which is run once more: those found in the store have no path."""
    lengths = batch.table["l1"]
    if np.isnan(lengths).all():
        return {}
    return artifacts(solver.solve(int(batch.table["seed"][np.nanargmin(lengths)])))


def _name(setup: Setup) -> str:
    return f"{setup.settings.label} on {setup.grid.name}"
