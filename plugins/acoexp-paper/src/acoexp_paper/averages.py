"""The averages of Tables 1-3: published, ours, and the interval in which ten trials' mean falls in 95 % of cases.

The paper's averages are means of ten trials, so they are held against the distribution of such means and not
against the interval of ours, which many more trials make narrow. Over an ensemble the map is drawn too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from acoexp.features import x2_last
from acoexp.report.measures import Sample
from acoexp.report.statistics import LEVEL, Estimate, Values
from acoexp_paper import published
from acoexp_paper.experiment import Experiment
from acoexp_paper.published import COLUMNS, PERFORMANCE, TRIALS

RESAMPLES = 10_000
X2_LAST = "x2_last"
"""x2 in its other reading, for which the paper's column x2 stands too."""

_HALF_A_DIGIT = {"x1": 0.05, "x2": 0.05, X2_LAST: 0.05, "x3": 0.05, "n_bar": 0.05, "n_c": 0.0}
_HALF_OF_LENGTHS = 0.00005


class Average(NamedTuple):
    """One average.

    Attributes:
        table: 1, 2 or 3.
        map: The environment.
        algorithm: The preset.
        column: The paper's column, or ``x2_last``.
        published: What the paper prints.
        first_ten: That of our seeds 0 to 9.
        ours: That of all our trials, with the interval of means of ten; of env1 that over its ensemble.
        ensemble: The same over the ensemble; None where there is none.
    """

    table: int
    map: str
    algorithm: str
    column: str
    published: float
    first_ten: float
    ours: Estimate
    ensemble: Estimate | None

    @property
    def inside(self) -> bool:
        """Whether the published average lies in the interval on the environment's map."""
        return self.lies_in(self.ours)

    @property
    def ensemble_inside(self) -> bool | None:
        """Whether it lies in that over the ensemble; None where there is none."""
        return None if self.ensemble is None else self.lies_in(self.ensemble)

    def lies_in(self, interval: Estimate) -> bool:
        """Tell whether the published average lies in an interval, to the digits that are printed."""
        slack = _HALF_A_DIGIT.get(self.column, _HALF_OF_LENGTHS) + 1e-9
        return interval.low - slack <= self.published <= interval.high + slack


def averages(experiment: Experiment) -> list[Average]:
    """Return all averages of Tables 1, 2 and 3."""
    found = []
    for table, env, algo, column, printed in _printed():
        sample = experiment.main[env][algo]
        values = values_of(sample, column)
        others = [values_of(samples[algo], column) for samples in experiment.ensembles[env]]
        scale = TRIALS if column == "n_c" else 1
        over_maps = mean_of_ten(others, scale) if others else None
        alone = over_maps if env == "env1" else None  # of whose map nothing but the optimum is known
        ours = alone or mean_of_ten([values], scale)
        first_ten = mean(values[:TRIALS]) * scale
        found.append(Average(table, env, algo, column, printed, first_ten, ours, over_maps))
    return found


def _printed() -> Iterator[tuple[int, str, str, str, float]]:
    """Yield table, environment, algorithm, column and what is printed there."""
    for table, env in ((1, "fig13"), (2, "env2")):
        for algo in ("aco", "pd", "pdg"):
            for column in COLUMNS:
                yield table, env, algo, column, published.average(table, algo, column)
            yield table, env, algo, X2_LAST, published.average(table, algo, "x2")
    for env in ("env1", "env2"):
        for algo in ("pf", "pdg"):
            for column in PERFORMANCE:
                yield 3, env, algo, column, published.performance(env, algo, column)


def fit_of(env: str, samples: dict[str, Sample]) -> dict[tuple[int, str], tuple[int, int]]:
    """Return for each block of the tables how many of its averages lie inside, of how many: (table, algorithm)."""
    counts: dict[tuple[int, str], tuple[int, int]] = {}
    for table, where, algo, column, printed in _printed():
        if where == env and column != X2_LAST and algo in samples:
            scale = TRIALS if column == "n_c" else 1
            ours = mean_of_ten([values_of(samples[algo], column)], scale)
            row = Average(table, env, algo, column, printed, ours.value, ours, None)
            inside, of = counts.get((table, algo), (0, 0))
            counts[table, algo] = (inside + row.inside, of + 1)
    return counts


def values_of(sample: Sample, column: str) -> Values:
    """Return what a column of the paper's says of each trial, float[n]; nan where it says nothing."""
    if column == X2_LAST:
        values = np.array([x2_last(curve) for curve in sample.curves], dtype=np.float64)
        return np.where(values > 0, values, np.nan)
    if column == "n_c":
        return sample.found.astype(np.float64)
    if column == "l_bar":
        return sample.features["l2"]
    if column == "n_bar":
        return np.where(sample.found, sample.features["x1"], np.nan)
    return sample.features[column]


def mean(values: Values) -> float:
    """Return the mean of the values that are there; nan without any."""
    there = values[~np.isnan(values)]
    return float(there.mean()) if there.size else np.nan


def mean_of_ten(maps: Sequence[Values], scale: float = 1) -> Estimate:
    """Return the mean of all values, and the interval of the mean of ten trials on one of the maps.

    Args:
        maps: Values on each map, float[n] each of one size; one map for no choice.
        scale: A factor for all three numbers.
    """
    values = np.array(maps)
    means = means_of_ten(values, RESAMPLES)
    tail = 100 * (1 - LEVEL) / 2
    there = means[~np.isnan(means)]
    low, high = np.percentile(there, (tail, 100 - tail)) if there.size else (np.nan, np.nan)
    return Estimate(scale * mean(values.ravel()), scale * float(low), scale * float(high))


def means_of_ten(values: Values, count: int) -> Values:
    """Return so many means of ten trials drawn from one of the maps, which is drawn too.

    Args:
        values: float[maps, n]; what is nan is left out of a mean, and a mean of nothing is nan.
        count: How many.
    """
    random = np.random.default_rng(0)
    on = random.integers(len(values), size=(count, 1))
    drawn = values[on, random.integers(values.shape[1], size=(count, TRIALS))]
    there = ~np.isnan(drawn)
    total, of = np.where(there, drawn, 0.0).sum(axis=1), there.sum(axis=1)
    return np.where(of > 0, total / np.maximum(of, 1), np.nan)
