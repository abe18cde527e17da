"""What a budget buys: the share of targets that are hit within it, and the gap that is left after it.

The two views of one thing, as COCO (Hansen et al. 2021) and IOHanalyzer (Wang et al. 2022) have them: fixed target
and fixed budget. A trial that is over has what it had at its end, whatever else could be spent.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.sample import Row, Sample
from acoexp.compare.statistics import interval_of_means

TARGETS = (0.0, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0)
"""Gaps to the optimum that a trial can hit, 0 the optimum itself."""

UNITS = ("cycles", "ant steps")
"""What is spent; ant steps in lengths of the map's optimum, so that large and small maps can be put together."""

_POINTS = 120

Curve = NDArray[np.float64]


class Anytime(NamedTuple):
    """What a configuration reaches within budgets, over maps; each float[budgets].

    Attributes:
        configuration: Its label.
        unit: What is spent, one of ``UNITS``.
        budgets: How much of it.
        hit: Mean over maps of the share of trials and targets that are hit.
        hit_low: Lower end of its bootstrap interval over maps; nan where there are too few.
        hit_high: Its upper end.
        gap: Median over maps of the median gap over seeds; inf where half of the maps have no path.
        gap_low: Lower quartile over maps.
        gap_high: Upper quartile.
    """

    configuration: str
    unit: str
    budgets: Curve
    hit: Curve
    hit_low: Curve
    hit_high: Curve
    gap: Curve
    gap_low: Curve
    gap_high: Curve

    def rows(self) -> list[Row]:
        """Return a row for each budget."""
        names = {"cell": self.configuration, "unit": self.unit}
        columns = [column.tolist() for column in self[2:]]
        return [{**names, **dict(zip(self._fields[2:], row, strict=True))} for row in zip(*columns, strict=True)]


def anytime(maps: Sequence[Sequence[Sample]], unit: str, *, inference: bool) -> list[Anytime]:
    """Return what each configuration reaches within budgets that all of them share.

    Args:
        maps: The samples of each map, in the same order of configurations on each.
        unit: One of ``UNITS``.
        inference: Whether the maps are enough for an interval over them.
    """
    budgets = _budgets([sample for samples in maps for sample in samples], unit)
    return [
        _of_one([samples[place] for samples in maps], unit, budgets, inference) for place in range(len(maps[0]))
    ]


def reached(sample: Sample, unit: str, budgets: Curve) -> NDArray[np.float64]:
    """Return the gap that each trial has within each budget, float[n, budgets]; inf before its first path."""
    gaps = np.column_stack([np.full(len(sample.gaps), np.inf), sample.gaps])
    if unit == "cycles":
        return gaps[:, np.minimum(budgets.astype(np.int64), sample.iterations)]
    spent = sample.steps / sample.optimum
    done = np.array([np.searchsorted(row, budgets, side="right") for row in spent])
    return np.take_along_axis(gaps, done, axis=1)


def _of_one(samples: Sequence[Sample], unit: str, budgets: Curve, inference: bool) -> Anytime:
    """Return what one configuration reaches on all maps."""
    shares, medians = np.empty((len(samples), budgets.size)), np.empty((len(samples), budgets.size))
    for place, sample in enumerate(samples):
        gaps = reached(sample, unit, budgets)
        shares[place] = 1.0 - np.searchsorted(TARGETS, gaps).mean(axis=0) / len(TARGETS)
        medians[place] = np.quantile(gaps, 0.5, axis=0, method="inverted_cdf")
    low, high = interval_of_means(shares) if inference else np.full((2, budgets.size), np.nan)
    lower, median, upper = np.quantile(medians, (0.25, 0.5, 0.75), axis=0, method="inverted_cdf")
    label = samples[0].configuration
    return Anytime(label, unit, budgets, shares.mean(axis=0), low, high, median, lower, upper)


def _budgets(samples: Sequence[Sample], unit: str) -> Curve:
    """Return budgets from the first that buys something to the last, evenly on a logarithmic scale."""
    if unit == "cycles":
        last = max(sample.iterations for sample in samples)
        return np.unique(np.geomspace(1, last, _POINTS).round())
    first = min(sample.steps[:, 0].min() / sample.optimum for sample in samples)
    last_of_all = max(sample.steps[:, -1].max() / sample.optimum for sample in samples)
    return np.geomspace(max(first, 1e-3), max(last_of_all, 1e-3) * (1.0 + 1e-9), _POINTS)
