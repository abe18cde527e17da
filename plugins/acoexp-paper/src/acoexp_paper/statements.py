"""Claims about one algorithm: a printed mean, a printed count, or something that is said of every trial."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from acoexp.report import statistics
from acoexp.report.measures import SIGNIFICANCE
from acoexp.report.statistics import Flags
from acoexp_paper.averages import mean_of_ten, means_of_ten, values_of
from acoexp_paper.kinds import Finding, Kind, Samples, mean_over
from acoexp_paper.published import NAMES, TRIALS
from acoexp_paper.trial_values import EVENTS

PRACTICALLY_ALL = 0.99
"""The share of trials from which on "every trial" is taken to hold."""

_RESAMPLES = 9999


@dataclass(frozen=True)
class MeanIs(Kind):
    """The mean of a column over ten trials is what the paper prints."""

    column: str
    algo: str
    printed: float
    compares = False

    @property
    def algos(self) -> tuple[str, ...]:  # type: ignore[override]
        """The one."""
        return (self.algo,)

    @property
    def text(self) -> str:
        """Such as "ACO-PDG needs 2.6 iterations on average"."""
        return f"{NAMES[self.algo]} needs {self.printed:g} iterations on average"

    def test(self, samples: Samples) -> Finding:
        """How often the mean of ten of our trials lies as far from ours as the printed one does."""
        return self._finding([samples])

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same, the map being drawn too."""
        return self._finding(maps)

    def glance(self, samples: Samples) -> tuple[float, float]:
        """p, and our mean."""
        finding = self._finding([samples])
        return finding.p, finding.effect.value

    def says(self, p: float, effect: float) -> int:
        """Whether the printed mean is one that ten trials may have."""
        return int(p >= SIGNIFICANCE)

    def _finding(self, maps: Sequence[Samples]) -> Finding:
        values = [values_of(samples[self.algo], self.column) for samples in maps]
        ours = mean_of_ten(values)
        statistic = f"Monte Carlo test of ten trials' mean, printed {self.printed:g}"
        return Finding(statistic, _rarity(np.array(values), self.printed), "mean", ours)


@dataclass(frozen=True)
class CountIs(Kind):
    """Something happened in so many of the paper's ten trials."""

    event: str
    algo: str
    printed: int
    compares = False

    @property
    def algos(self) -> tuple[str, ...]:  # type: ignore[override]
        """The one."""
        return (self.algo,)

    @property
    def text(self) -> str:
        """Such as "ACO-PD finds the optimum in 8 of ten trials"."""
        return f"{NAMES[self.algo]} {EVENTS[self.event].words} in {self.printed} of ten trials"

    def test(self, samples: Samples) -> Finding:
        """Fisher's exact test of the paper's ten trials against ours."""
        flags = EVENTS[self.event].flags(samples[self.algo])
        rate = statistics.success_rate(flags)
        statistic = (
            f"Fisher's exact test, {self.printed} of {TRIALS} printed, {int(flags.sum())} of {flags.size} ours"
        )
        return Finding(statistic, self._p(flags), "share of trials", rate)

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same with the trials of all maps together; the interval is over maps."""
        flags = [EVENTS[self.event].flags(samples[self.algo]) for samples in maps]
        shares = np.array([f.mean() for f in flags])
        return Finding(
            f"Fisher's exact test over {len(maps)} maps",
            self._p(np.concatenate(flags)),
            "mean share of trials",
            mean_over(shares),
        )

    def glance(self, samples: Samples) -> tuple[float, float]:
        """p, and our share."""
        flags = EVENTS[self.event].flags(samples[self.algo])
        return self._p(flags), float(flags.mean())

    def says(self, p: float, effect: float) -> int:
        """Whether ten of our trials may give the printed count."""
        return int(p >= SIGNIFICANCE)

    def _p(self, flags: Flags) -> float:
        ours = int(flags.sum())
        counts = [[self.printed, TRIALS - self.printed], [ours, flags.size - ours]]
        return float(stats.fisher_exact(counts).pvalue)


@dataclass(frozen=True)
class Every(Kind):
    """Something happens in every trial; held to mean at least 99 % of them."""

    event: str
    algo: str
    compares = False

    @property
    def algos(self) -> tuple[str, ...]:  # type: ignore[override]
        """The one."""
        return (self.algo,)

    @property
    def text(self) -> str:
        """Such as "ACO-PDG finds the optimum in every trial"."""
        return f"{NAMES[self.algo]} {EVENTS[self.event].words} in every trial"

    def test(self, samples: Samples) -> Finding:
        """The one-sided binomial test of a share of at least 99 %, and the share with Wilson's interval."""
        flags = EVENTS[self.event].flags(samples[self.algo])
        statistic = f"binomial test of at least {PRACTICALLY_ALL:.0%}, {int(flags.sum())} of {flags.size}"
        return Finding(statistic, self._p(flags), "share of trials", statistics.success_rate(flags))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same with the trials of all maps together; the interval is over maps."""
        flags = [EVENTS[self.event].flags(samples[self.algo]) for samples in maps]
        shares = np.array([f.mean() for f in flags])
        statistic = f"binomial test of at least {PRACTICALLY_ALL:.0%} over {len(maps)} maps"
        return Finding(statistic, self._p(np.concatenate(flags)), "mean share of trials", mean_over(shares))

    def glance(self, samples: Samples) -> tuple[float, float]:
        """p, and the share."""
        flags = EVENTS[self.event].flags(samples[self.algo])
        return self._p(flags), float(flags.mean())

    def says(self, p: float, effect: float) -> int:
        """Whether so many exceptions are too many."""
        return int(p >= SIGNIFICANCE)

    def _p(self, flags: Flags) -> float:
        return float(stats.binomtest(int(flags.sum()), flags.size, PRACTICALLY_ALL, alternative="less").pvalue)


def _rarity(values: NDArray[np.float64], printed: float) -> float:
    """Return the share of means of ten trials that lie as far from the mean of all as the printed one, at least.

    Args:
        values: float[maps, n], nan where there is none.
        printed: The printed mean.
    """
    if np.isnan(values).all():
        return 0.0
    centre = float(np.nanmean(values))

    def means(size: tuple[int, ...]) -> NDArray[np.float64]:
        return means_of_ten(values, size[0])[:, None]

    def distance(mean: NDArray[np.float64], axis: int) -> NDArray[np.float64]:
        off = np.abs(np.nan_to_num(mean, nan=np.inf) - centre).round(9)
        return np.asarray(off.max(axis=axis), dtype=np.float64)

    test = stats.monte_carlo_test([printed], means, distance, n_resamples=_RESAMPLES, alternative="greater")
    return float(test.pvalue)
