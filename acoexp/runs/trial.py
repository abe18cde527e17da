"""One trial that is kept: solved, then put into the store; why it failed, if it did."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

from acoexp.errors import StrategyError
from acoexp.tracking.setup import Artifacts, Setup, Trial
from acoexp.tracking.tracker import Tracker
from acoexp.trial.result import Result
from acoexp.trial.solver import Solver


def keep_trial(
    setup: Setup,
    seed: int,
    tracker: Tracker,
    *,
    solver: Callable[[], Solver] | None = None,
    resume: bool = True,
    show: Callable[[Trial], None] = lambda trial: None,
    artifacts: Callable[[Result], Artifacts] = lambda result: {},
    ready: Callable[[], None] = lambda: None,
) -> Trial:
    """Run one trial and keep it.

    Args:
        setup: What it is a trial of.
        seed: Its seed.
        tracker: Where it is kept.
        solver: Returns the solver for the setup, where one is kept from trial to trial; else one is made.
        resume: Whether the same trial, if it is there, stays; otherwise this one takes its place.
        show: Called with the trial as soon as it is solved, before it is kept.
        artifacts: Returns what its run carries.
        ready: Makes the tracker ready where it is not yet, once there is something to keep.

    Raises:
        StrategyError: if a part broke its contract; the tracker then has the reason.
        TrackingError: if it cannot be kept.
    """
    try:
        made = Solver(setup.grid, setup.settings) if solver is None else solver()
        began = time.perf_counter()
        result = made.solve(seed)
        seconds = time.perf_counter() - began
    except StrategyError as problem:
        ready()
        tracker.log_failure(setup, seed, str(problem))
        raise
    trial = Trial(setup, result, seconds)
    show(trial)
    trial = replace(trial, artifacts=artifacts(result))
    ready()
    tracker.log(trial, resume=resume)
    return trial
