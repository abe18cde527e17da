"""Values of each configuration on each map, one each: what seeds are for is done here, and no more."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.sample import Row, Sample

CLOSE = 0.01
"""Gap to the optimum of a path that counts as good: a hundredth."""

Matrix = NDArray[np.float64]
"""Values, float[maps, configurations]; smaller ones are better, and inf is the worst."""


@dataclass(frozen=True, eq=False)
class MapValues:
    """What each configuration is worth on each map.

    Attributes:
        maps: The maps' names.
        configurations: The configurations' labels.
        gaps: Median over seeds of the gap between a trial's best path and the exact optimum, as a share of it; a
            trial whose ants were all lost counts as the worst, and the value is inf where half of them are.
        costs: Expected ant steps until a trial comes ``CLOSE`` to the optimum: steps spent by all trials per
            trial that did; inf where none did.
    """

    maps: list[str]
    configurations: list[str]
    gaps: Matrix
    costs: Matrix

    def rows(self) -> list[Row]:
        """Return them as rows, one for each map and configuration."""
        return [
            {"map": name, "cell": label, "gap": float(self.gaps[i, j]), "ant_steps": float(self.costs[i, j])}
            for i, name in enumerate(self.maps)
            for j, label in enumerate(self.configurations)
        ]


def values_of_maps(maps: Sequence[Sequence[Sample]]) -> MapValues:
    """Return the values of the samples of each map, in the same order of configurations on each."""
    return MapValues(
        maps=[samples[0].map for samples in maps],
        configurations=[sample.configuration for sample in maps[0]],
        gaps=_matrix(maps, median_gap),
        costs=_matrix(maps, expected_cost),
    )


def median_gap(sample: Sample) -> float:
    """Return the gap of the trial in the middle; of two the better one, so that it is one that a trial had."""
    return float(np.quantile(sample.gaps[:, -1], 0.5, method="inverted_cdf"))


def expected_cost(sample: Sample) -> float:
    """Return the steps of all trials until each came close, or else all of its steps, per trial that did."""
    close = sample.gaps <= CLOSE
    arrived = close.any(axis=1)
    cycle = np.where(arrived, close.argmax(axis=1), sample.iterations - 1)
    spent = sample.steps[np.arange(len(close)), cycle].sum()
    return float(spent / arrived.sum()) if arrived.any() else np.inf


def _matrix(maps: Sequence[Sequence[Sample]], value: Callable[[Sample], float]) -> Matrix:
    return np.array([[value(sample) for sample in samples] for samples in maps], dtype=np.float64)
