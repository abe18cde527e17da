"""Averages of Tables 1-3: published, ours, and the interval in which ten trials' mean falls in 95 % of cases."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from acoexp.compare.sample import Sample
from acoexp.compare.statistics import Estimate
from acoexp_paper.claims.means import mean, mean_of_ten
from acoexp_paper.published import tables
from acoexp_paper.published.tables import ALGOS, COLUMNS, TABLE_3, TABLES, TRIALS
from acoexp_paper.trials.samples import X2_LAST, Samples, values_of

_HALF_A_DIGIT = {"x1": 0.05, "x2": 0.05, X2_LAST: 0.05, "x3": 0.05, "n_bar": 0.05, "n_c": 0.0}
_HALF_OF_LENGTHS = 0.00005


Fit = dict[tuple[int, str, str], tuple[int, int]]
"""By table, map and algorithm, how many published averages lie inside, of how many."""


class Printed(NamedTuple):
    """An average as the paper prints it.

    Attributes:
        table: 1, 2 or 3.
        map: The environment.
        algorithm: The preset.
        column: The paper's column, or ``x2_last``.
        value: What the paper prints.
    """

    table: int
    map: str
    algorithm: str
    column: str
    value: float

    @property
    def scale(self) -> int:
        """What a mean over trials is multiplied by; n_c is a count of ten."""
        return TRIALS if self.column == "n_c" else 1

    @property
    def fitted(self) -> bool:
        """Whether the search for the maps looked at it: x1, x3 and the lengths of standard ACO."""
        return self.algorithm == "aco" and self.column in ("x1", "l1", "l2", "x3")

    def lies_in(self, interval: Estimate) -> bool:
        """Return whether it lies in an interval, to the digits that are printed."""
        slack = _HALF_A_DIGIT.get(self.column, _HALF_OF_LENGTHS) + 1e-9
        return interval.low - slack <= self.value <= interval.high + slack

    def ours(self, samples: Sequence[Sample]) -> Estimate:
        """Return the mean of our trials, and the interval of means of ten on one of their maps."""
        return mean_of_ten([values_of(sample, self.column) for sample in samples], self.scale)


class Average(NamedTuple):
    """An average beside ours.

    Attributes:
        printed: What the paper prints.
        first_ten: That of our seeds 0 to 9 on the environment's own map.
        ours: That of all trials on it, with the interval of means of ten.
        over_maps: The same where the map is drawn from all of the environment's; None where there is one.
    """

    printed: Printed
    first_ten: float
    ours: Estimate
    over_maps: Estimate | None

    @property
    def inside(self) -> bool:
        """Whether the published average lies in the interval on the environment's own map."""
        return self.printed.lies_in(self.ours)

    @property
    def inside_over_maps(self) -> bool | None:
        """Whether it lies in that over all maps; None where there is one."""
        return None if self.over_maps is None else self.printed.lies_in(self.over_maps)


def averages(maps: Mapping[str, Sequence[Samples]]) -> list[Average]:
    """Return all averages of Tables 1, 2 and 3 beside ours.

    Args:
        maps: The samples on each map of each environment, its own map first.
    """
    return [_beside(printed, [s[printed.algorithm] for s in maps[printed.map]]) for printed in printed_averages()]


def _beside(printed: Printed, samples: Sequence[Sample]) -> Average:
    first_ten = mean(values_of(samples[0], printed.column)[:TRIALS]) * printed.scale
    over_maps = printed.ours(samples) if len(samples) > 1 else None
    return Average(printed, first_ten, printed.ours(samples[:1]), over_maps)


def printed_averages() -> Iterator[Printed]:
    """Yield the averages of Tables 1, 2 and 3, those of x2 once for each of its readings."""
    for table, env in TABLES.items():
        for algo in ALGOS:
            for column in COLUMNS:
                yield Printed(table, env, algo, column, tables.average(table, algo, column))
            yield Printed(table, env, algo, X2_LAST, tables.average(table, algo, "x2"))
    for env in TABLE_3.environments:
        for algo in TABLE_3.algos:
            for column in TABLE_3.columns:
                yield Printed(3, env, algo, column, tables.performance(env, algo, column))


def averages_met(maps: Mapping[str, Sequence[Samples]]) -> Fit:
    """Return how many published averages lie inside over all maps.

    Args:
        maps: The samples on each map of some environments, of some algorithms.
    """
    counts: Fit = {}
    for printed in printed_averages():
        there = maps.get(printed.map)
        if there and printed.algorithm in there[0] and printed.column != X2_LAST:
            inside = printed.lies_in(printed.ours([samples[printed.algorithm] for samples in there]))
            met, of = counts.get(printed[:3], (0, 0))
            counts[printed[:3]] = (met + inside, of + 1)
    return counts
