"""One trial that is kept: solved, then put into the store; why it failed, if it did."""

from __future__ import annotations

import time
from typing import NamedTuple

from acoexp.errors import StrategyError
from acoexp.tracking.setup import Setup, Trial
from acoexp.tracking.tracker import Tracker
from acoexp.trial.solver import Solver


class KeptTrial(NamedTuple):
    """A trial that is in the store, and the time that it took to solve."""

    trial: Trial
    seconds: float


def keep_trial(setup: Setup, seed: int, tracker: Tracker, *, resume: bool = True) -> KeptTrial:
    """Run one trial and keep it.

    Args:
        setup: What it is a trial of.
        seed: Its seed.
        tracker: Where it is kept.
        resume: Whether the same trial, if it is there, stays; otherwise this one takes its place.

    Raises:
        StrategyError: if a part broke its contract; the tracker then has the reason.
        TrackingError: if it cannot be kept.
    """
    try:
        solver = Solver(setup.grid, setup.settings)
        began = time.perf_counter()
        trial = Trial(setup, solver.solve(seed))
        seconds = time.perf_counter() - began
    except StrategyError as problem:
        tracker.log_failure(setup, seed, str(problem))
        raise
    tracker.log(trial, resume=resume)
    return KeptTrial(trial, seconds)
