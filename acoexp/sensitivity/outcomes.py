"""What a trial came to, as numbers of which each trial has one."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.trial.settings import Settings
from acoexp.trial.trials import Trials

Array = NDArray[np.float64]

OUTCOMES = {
    "gap": "gap of the best length to the optimum (%)",
    "cycles": "cycles until the optimum was found (at most all that were run)",
    "found": "trials that found the optimum (%)",
    "lost": "ants that were lost (%)",
}
"""The outcomes, the one that a report speaks of first at the beginning."""


@dataclass(frozen=True, eq=False)
class Measured:
    """What the trials of one configuration came to, each float[n].

    Attributes:
        outcomes: By name; ``gap`` is nan where no ant arrived.
        found: Whether each trial found the optimum, bool[n].
    """

    outcomes: dict[str, Array]
    found: NDArray[np.bool_]

    @classmethod
    def of(cls, trials: Trials, grid: Grid, settings: Settings) -> Measured:
        """Return what trials came to; a trial that missed the optimum spent all cycles that it ran."""
        table, ants = trials.table, settings.scalars.ants
        found = table["l1"] == grid.optimum
        return cls(
            {
                "gap": 100.0 * (table["l1"] / grid.optimum - 1.0),
                "cycles": np.where(found, table["x1"], table["cycles"]).astype(np.float64),
                "found": np.where(found, 100.0, 0.0),
                "lost": 100.0 * table["lost_ants"] / (ants * table["cycles"]),
            },
            found,
        )

    @property
    def never_arrived(self) -> int:
        """In how many trials no ant arrived."""
        return int(np.isnan(self.outcomes["gap"]).sum())

    def with_gap(self, worst: float) -> dict[str, Array]:
        """Return the outcomes with a gap for trials in which no ant arrived."""
        return {**self.outcomes, "gap": np.nan_to_num(self.outcomes["gap"], nan=worst)}

    @property
    def expected_cycles(self) -> float:
        """Cycles spent by all trials per success (Auger, Hansen 2005); infinite if there is none."""
        successes = int(self.found.sum())
        return float(self.outcomes["cycles"].sum() / successes) if successes else np.inf
