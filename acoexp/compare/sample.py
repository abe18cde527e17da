"""A sample: the trials of one configuration on one map, as all measures, tests and pictures take them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.statistics import Flags, Values

Row = dict[str, Any]
"""What is said of one or more samples, by column; plain values for every table and file."""

_DIGITS = 14
"""Of a gap, so that 11 beside 10 is a tenth whatever the computer makes of it."""


@dataclass(frozen=True, eq=False)
class Sample:
    """The trials of one configuration on one map, seeds 0..n-1.

    Attributes:
        configuration: The configuration's label.
        map: The map's name.
        optimum: Exact optimum of the map, in cells.
        found: Whether each trial found the optimum, bool[n].
        features: By name, float[n], nan where there is none.
        curves: Best length found in each cycle, float[n, longest]; nan where all ants were lost. A trial that
            ended sooner than another stays as it was in its last cycle.
        steps: Moves that all ants together have made by the end of each cycle, int64[n, longest].
    """

    configuration: str
    map: str
    optimum: float
    found: Flags
    features: dict[str, Values]
    curves: NDArray[np.float64]
    steps: NDArray[np.int64]

    @property
    def iterations(self) -> int:
        """Cycles of the longest trial."""
        return int(self.curves.shape[1])

    @cached_property
    def gaps(self) -> NDArray[np.float64]:
        """By what share the best path so far is longer than the optimum, float[n, iterations]; inf without one.

        A gap of 0 is the optimum, of 0.1 a path that is longer by a tenth.
        """
        best = np.minimum.accumulate(np.where(np.isnan(self.curves), np.inf, self.curves), axis=1)
        return np.round((best - self.optimum) / self.optimum, _DIGITS)

    def hitting_time(self, censored: int) -> Values:
        """Return the cycle in which each trial found the optimum, or ``censored``, float[n]."""
        return np.where(self.found, self.features["x1"], censored)

    def convergence(self, worst: float) -> Values:
        """Return l2 of each trial, or ``worst`` where there is none, float[n]."""
        return np.nan_to_num(self.features["l2"], nan=worst)
