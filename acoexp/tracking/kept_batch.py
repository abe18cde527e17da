"""A batch that is kept: what the store already has is taken from there, the rest is run, and all is one run."""

from __future__ import annotations

import logging
from collections.abc import Callable

import numpy as np

from acoexp.batch import Batch, run_batch
from acoexp.errors import StrategyError
from acoexp.seeds import Seeds
from acoexp.solver import Solver
from acoexp.tracking.setup import Setup
from acoexp.tracking.tracker import Tracker
from acoexp.trials import Trials, aggregate, csv_lines

log = logging.getLogger(__name__)


def keep_batch(
    setup: Setup,
    seeds: Seeds,
    tracker: Tracker,
    *,
    threads: int | None = None,
    resume: bool = True,
    receive: Callable[[Trials], None] = lambda portion: None,
    tell: Callable[[int], None] = lambda done: None,
) -> Batch:
    """Run what is missing of a batch and keep it.

    Args:
        setup: What its trials are of.
        seeds: Their seeds.
        tracker: Where they are kept.
        threads: How many threads; by default one for each processor.
        resume: Whether trials that the tracker has are taken from there; otherwise all are run, and the new run
            takes the old one's place.
        receive: Called with each portion of trials, those that were there and those that were run.
        tell: Called now and then with the number of trials that are finished or failed.

    Raises:
        StrategyError: if the colony cannot be made. A trial that fails is in the batch's ``failures``.
        TrackingError: if the batch cannot be kept.
    """
    there = tracker.find_trials(setup.cell, seeds) if resume else []
    for portion in there:
        receive(portion)
    found = sum(map(len, there))
    if found:
        log.info("%d of %d trials found in the store", found, len(seeds))
    if found == len(seeds) and tracker.has(setup.identity(seeds)):
        return run_batch(Solver(setup.grid, setup.settings), (), receive, there=there, tell=tell)
    run = tracker.begin(setup, seeds, anew=not resume)

    def keep(portion: Trials) -> None:
        run.keep(portion)
        receive(portion)

    try:
        solver = Solver(setup.grid, setup.settings)
        for portion in there:
            run.keep(portion)
        batch = run_batch(solver, _missing(seeds, there), keep, threads=threads, there=there, tell=tell)
        if not len(batch.table):
            raise StrategyError(f"all {len(seeds)} trials failed: {batch.failures[0].reason}")
        summary = aggregate(batch.table, setup.grid.optimum, setup.settings.scalars.iterations)
        failed = {failure.seed: str(failure.reason) for failure in batch.failures}
        run.finish(summary, batch.curve, csv_lines(batch.table), failed)
    except BaseException as problem:
        run.abandon(str(problem) or type(problem).__name__)
        raise
    return batch


def _missing(seeds: Seeds, there: list[Trials]) -> Seeds | list[int]:
    if not there:
        return seeds
    missing: list[int] = np.setdiff1d(seeds.array(), np.concatenate([t.seeds for t in there])).tolist()
    return missing
