"""Outcomes: a trial that came to no result, and what many trials came to."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.errors import StrategyError


class Failure(NamedTuple):
    """A trial that came to no result, and why."""

    seed: int
    reason: StrategyError


class Batch(NamedTuple):
    """What a batch found.

    Attributes:
        table: Features of type ``TABLE``, one row for each finished trial, in the order of the seeds.
        curve: Mean of the best length found in each cycle, float[iterations], over the trials in which an ant
            arrived in it; nan where none did in any. A trial that ended sooner stays as it was in its last cycle.
        best: Mean of the best length found up to each cycle, likewise.
        failures: The trials that came to no result.
        ran: How many trials were run to their end, besides those that were found.
        seconds: Time that these took together.
    """

    table: NDArray[np.void]
    curve: NDArray[np.float64]
    best: NDArray[np.float64]
    failures: list[Failure]
    ran: int
    seconds: float
