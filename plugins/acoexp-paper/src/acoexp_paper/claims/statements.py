"""Claims about one algorithm: a printed mean, a printed count, or something that is said of every trial."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy  # scipy.stats is imported when first used

from acoexp.compare import statistics
from acoexp.compare.statistics import SIGNIFICANCE, Flags
from acoexp_paper.claims.kinds import Finding, Kind, mean_over
from acoexp_paper.claims.means import mean_of_ten, rarity
from acoexp_paper.published.tables import NAMES, TRIALS
from acoexp_paper.trials.samples import EVENTS, Samples, values_of

PRACTICALLY_ALL = 0.99
"""The share of trials from which on "every trial" is taken to hold."""


@dataclass(frozen=True)
class Statement(Kind):
    """Something is said of the trials of one algorithm.

    Attributes:
        what: The column or event that it is said of, by name.
        algo: The algorithm.
    """

    what: str
    algo: str
    compares = False

    @property
    def algos(self) -> tuple[str, ...]:
        """The one."""
        return (self.algo,)

    def says(self, p: float, effect: float) -> int:
        """That it stands, unless it is rejected."""
        return int(p >= SIGNIFICANCE)


@dataclass(frozen=True)
class MeanIs(Statement):
    """The mean of a column over ten trials is what the paper prints."""

    printed: float

    @property
    def text(self) -> str:
        """Such as "ACO-PDG needs 2.6 iterations on average"."""
        return f"{NAMES[self.algo]} needs {self.printed:g} iterations on average"

    def test(self, samples: Samples) -> Finding:
        """How often the mean of ten of our trials lies as far from ours as the printed one does."""
        return self.test_over([samples])

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same, the map being drawn too."""
        values = [values_of(samples[self.algo], self.what) for samples in maps]
        statistic = f"Monte Carlo test of ten trials' mean, printed {self.printed:g}"
        return Finding(statistic, rarity(values, self.printed), "mean", mean_of_ten(values))

    def p_and_effect(self, samples: Samples) -> tuple[float, float]:
        """p, and our mean."""
        finding = self.test(samples)
        return finding.p, finding.effect.value


@dataclass(frozen=True)
class Frequency(Statement):
    """Something happens in so many trials."""

    def test(self, samples: Samples) -> Finding:
        """The test of our trials, and the share of them with Wilson's interval."""
        flags = self._flags(samples)
        statistic = f"{self._test}, {self._counts(flags)}"
        return Finding(statistic, self._p(flags), "share of trials", statistics.success_rate(flags))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same with the trials of all maps together; the interval is over maps."""
        flags = [self._flags(samples) for samples in maps]
        shares = mean_over(np.array([f.mean() for f in flags]))
        statistic = f"{self._test} over {len(maps)} maps"
        return Finding(statistic, self._p(np.concatenate(flags)), "mean share of trials", shares)

    def p_and_effect(self, samples: Samples) -> tuple[float, float]:
        """p, and our share."""
        flags = self._flags(samples)
        return self._p(flags), float(flags.mean())

    def _flags(self, samples: Samples) -> Flags:
        return EVENTS[self.what].flags(samples[self.algo])

    @property
    @abstractmethod
    def _test(self) -> str:
        """The name of the test."""

    @abstractmethod
    def _counts(self, flags: Flags) -> str:
        """Return what is counted, in words."""

    @abstractmethod
    def _p(self, flags: Flags) -> float:
        """Return the p value of the statement."""


@dataclass(frozen=True)
class CountIs(Frequency):
    """Something happened in so many of the paper's ten trials: Fisher's exact test of these against ours."""

    printed: int
    _test = "Fisher's exact test"

    @property
    def text(self) -> str:
        """Such as "ACO-PD finds the optimum in 8 of ten trials"."""
        return f"{NAMES[self.algo]} {EVENTS[self.what].words} in {self.printed} of ten trials"

    def _counts(self, flags: Flags) -> str:
        return f"{self.printed} of {TRIALS} printed, {int(flags.sum())} of {flags.size} ours"

    def _p(self, flags: Flags) -> float:
        ours = int(flags.sum())
        counts = [[self.printed, TRIALS - self.printed], [ours, flags.size - ours]]
        return float(scipy.stats.fisher_exact(counts).pvalue)


@dataclass(frozen=True)
class Every(Frequency):
    """Something happens in every trial: the one-sided binomial test of a share of at least 99 %."""

    _test = f"binomial test of at least {PRACTICALLY_ALL:.0%}"

    @property
    def text(self) -> str:
        """Such as "ACO-PDG finds the optimum in every trial"."""
        return f"{NAMES[self.algo]} {EVENTS[self.what].words} in every trial"

    def _counts(self, flags: Flags) -> str:
        return f"{int(flags.sum())} of {flags.size}"

    def _p(self, flags: Flags) -> float:
        return float(
            scipy.stats.binomtest(int(flags.sum()), flags.size, PRACTICALLY_ALL, alternative="less").pvalue
        )
