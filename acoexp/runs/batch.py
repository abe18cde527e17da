"""A batch that is kept: what the store already has is taken from there, the rest is run, and all is one run."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.tracking.setup import Setup
from acoexp.tracking.tracker import BatchLog, Tracker
from acoexp.trial.batch import Batch, run_batch
from acoexp.trial.seeds import Seeds
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver
from acoexp.trial.table import aggregate, csv_lines
from acoexp.trial.trials import Trials

log = logging.getLogger(__name__)


def keep_batch(
    setup: Setup,
    seeds: Seeds,
    tracker: Tracker,
    *,
    threads: int | None = None,
    resume: bool = True,
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
        receive: Called with each portion of trials, those that were found and those that were run.
        show: Called now and then with the number of trials that are finished or failed.

    Raises:
        SettingsError: for a number of threads that is not one.
        StrategyError: if the colony cannot be made. A trial that fails is in the batch's ``failures``.
        TrackingError: if the batch cannot be kept.
    """
    known = resume and tracker.has(setup.identity(seeds))
    run = None if known else tracker.begin(setup, seeds, resume=resume)

    def keep(portion: Trials) -> None:
        if run is not None:
            run.keep(portion)
        receive(portion)

    found: list[NDArray[np.uint64]] = []

    def kept_before() -> Iterator[Trials]:
        for portion in tracker.find_trials(setup.configuration_id, seeds) if resume else ():
            found.append(portion.seeds)
            keep(portion)
            yield portion
        if found:
            total = sum(map(len, found))
            log.info("%s: %d of %d trials found in the store", _name(setup), total, len(seeds))

    try:
        solver = Solver(setup.grid, setup.settings)
        batch = run_batch(
            lambda receive: solver.run(_missing(seeds, found), receive, threads),
            setup.settings.scalars.iterations,
            keep,
            found=kept_before(),
            show=show,
        )
        if run is not None:
            _finish(run, setup, batch)
    except BaseException as problem:
        if run is not None:
            run.abandon(str(problem) or type(problem).__name__)
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
        receive=portions.append,
        show=show,
    )
    for failure in batch.failures:
        raise failure.reason
    return Trials.joined(portions)


def _missing(seeds: Seeds, found: list[NDArray[np.uint64]]) -> Iterator[int]:
    """Yield the seeds that are not found; nothing is looked at before the first is asked for."""
    yield from np.setdiff1d(seeds.array(), np.concatenate(found)).tolist() if found else seeds


def _finish(run: BatchLog, setup: Setup, batch: Batch) -> None:
    iterations = setup.settings.scalars.iterations
    summary = aggregate(batch.table, setup.grid.optimum, iterations) if len(batch.table) else None
    failed = {failure.seed: str(failure.reason) for failure in batch.failures}
    run.finish(summary, batch.curve, csv_lines(batch.table), failed)


def _name(setup: Setup) -> str:
    return f"{setup.settings.label} on {setup.grid.name}"
