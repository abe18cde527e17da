"""Ranks over maps: Friedman's test, and Nemenyi's of each two configurations.

On each map the configurations are ranked, 1 the best, ties with the mean of their ranks. Sources: Friedman 1937;
Iman, Davenport 1980; Nemenyi 1963; Demsar 2006 (Statistical comparisons of classifiers over multiple data sets).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used
from numpy.typing import NDArray

from acoexp.compare.over_maps.values import Matrix
from acoexp.compare.statistics import SIGNIFICANCE

Ranks = NDArray[np.float64]


class Friedman(NamedTuple):
    """Friedman's test.

    Attributes:
        chi2: His statistic, corrected for ties.
        p: Its p, by the chi-squared distribution.
        f: Iman and Davenport's F of it, which is less conservative; inf where all maps rank alike.
        f_p: Its p, by the F distribution; verdicts go by it.
    """

    chi2: float
    p: float
    f: float
    f_p: float


def ranks_of(values: Matrix) -> Ranks:
    """Return the rank of each configuration on each map, float[maps, configurations]; equal values share it."""
    ranks: Ranks = scipy.stats.rankdata(values, axis=1)
    return ranks


def friedman(ranks: Ranks) -> Friedman | None:
    """Return the test of three or more configurations; None where all tie on every map, which it cannot judge."""
    maps, count = ranks.shape
    if (ranks == ranks[:, :1]).all():
        return None
    test = scipy.stats.friedmanchisquare(*ranks.T)
    chi2, p = float(test.statistic), float(test.pvalue)
    left = maps * (count - 1) - chi2
    if left <= 1e-9 * chi2:
        return Friedman(chi2, p, np.inf, 0.0)
    f = (maps - 1) * chi2 / left
    return Friedman(chi2, p, f, float(scipy.stats.f.sf(f, count - 1, (count - 1) * (maps - 1))))


def critical_difference(configurations: int, maps: int) -> float:
    """Return by how much two mean ranks must differ, at 5 %, for Nemenyi's test to tell them apart."""
    q = scipy.stats.studentized_range.ppf(1.0 - SIGNIFICANCE, configurations, np.inf)
    return float(q / np.sqrt(2.0) * _deviation(configurations, maps))


def nemenyi(first: float, second: float, configurations: int, maps: int) -> float:
    """Return the p of two mean ranks, corrected for all pairs of the configurations."""
    q = abs(first - second) / _deviation(configurations, maps) * np.sqrt(2.0)
    return float(scipy.stats.studentized_range.sf(q, configurations, np.inf))


def cliques(mean_ranks: NDArray[np.float64], difference: float) -> list[list[int]]:
    """Return the largest groups of configurations within which no two mean ranks differ by more than that.

    Args:
        mean_ranks: float[configurations].
        difference: The critical difference.

    Returns:
        Groups of two or more places, each from the best rank to the worst.
    """
    order = np.argsort(mean_ranks, kind="stable").tolist()
    groups: list[list[int]] = []
    for first in range(len(order)):
        group = [place for place in order[first:] if mean_ranks[place] - mean_ranks[order[first]] <= difference]
        if len(group) > 1 and not (groups and groups[-1][-1] == group[-1]):
            groups.append(group)
    return groups


def _deviation(configurations: int, maps: int) -> float:
    return float(np.sqrt(configurations * (configurations + 1) / (6.0 * maps)))
