"""Claims that compare two algorithms, on the same seeds and so in pairs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from acoexp.report import statistics
from acoexp.report.measures import SIGNIFICANCE
from acoexp.report.statistics import Flags, Values
from acoexp_paper.kinds import Finding, Kind, Samples, mean_over
from acoexp_paper.published import NAMES
from acoexp_paper.trial_values import EVENTS, MEASURES


@dataclass(frozen=True)
class Fewer(Kind):
    """Trials of ``a`` have a smaller value than those of ``b`` with the same seeds."""

    measure: str
    a: str
    b: str
    compares = True

    @property
    def algos(self) -> tuple[str, ...]:  # type: ignore[override]
        """Both."""
        return self.a, self.b

    @property
    def text(self) -> str:
        """Such as "ACO-PD loses fewer ants than standard ACO"."""
        return f"{NAMES[self.a]} {MEASURES[self.measure].smaller} than {NAMES[self.b]}"

    def test(self, samples: Samples) -> Finding:
        """The exact sign test of the pairs, and A12 with its bootstrap interval."""
        a, b = self._values(samples)
        statistic = f"sign test, {int((a < b).sum())} of {a.size} pairs smaller, {int((a > b).sum())} larger"
        return Finding(statistic, statistics.sign_test(a, b), "A12", statistics.superiority(a, b))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """Wilcoxon's signed-rank test of A12 over maps, and its mean."""
        effects = np.array([self.glance(samples)[1] for samples in maps])
        p = float(stats.wilcoxon(effects - 0.5).pvalue) if (effects != 0.5).any() else 1.0
        return Finding(f"signed-rank test of A12 over {len(maps)} maps", p, "mean A12", mean_over(effects))

    def glance(self, samples: Samples) -> tuple[float, float]:
        """The same test, and A12 from Mann and Whitney's U."""
        a, b = self._values(samples)
        wins = stats.mannwhitneyu(b, a, method="asymptotic").statistic
        return statistics.sign_test(a, b), float(wins) / (a.size * b.size)

    def says(self, p: float, effect: float) -> int:
        """By the side on which A12 lies, if the difference is significant."""
        return int(np.sign(effect - 0.5)) if p < SIGNIFICANCE else 0

    def _values(self, samples: Samples) -> tuple[Values, Values]:
        a, b = samples[self.a], samples[self.b]
        return MEASURES[self.measure].values(a), MEASURES[self.measure].values(b)


@dataclass(frozen=True)
class MoreOften(Kind):
    """Something happens in more trials of ``a`` than of ``b``."""

    event: str
    a: str
    b: str
    compares = True

    @property
    def algos(self) -> tuple[str, ...]:  # type: ignore[override]
        """Both."""
        return self.a, self.b

    @property
    def text(self) -> str:
        """Such as "ACO-PD finds the optimum more often than standard ACO"."""
        return f"{NAMES[self.a]} {EVENTS[self.event].words} more often than {NAMES[self.b]}"

    def test(self, samples: Samples) -> Finding:
        """McNemar's exact test, and the odds ratio that belongs to it."""
        a, b = self._flags(samples)
        statistic = f"McNemar, {a.mean():.1%} against {b.mean():.1%} of {a.size} trials"
        return Finding(statistic, statistics.sign_test(a, b), "odds ratio", statistics.odds_ratio(a, b))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """Wilcoxon's signed-rank test of the difference in shares over maps, and its mean."""
        shares = np.array([[flags.mean() for flags in self._flags(samples)] for samples in maps])
        difference = shares[:, 0] - shares[:, 1]
        p = float(stats.wilcoxon(difference).pvalue) if difference.any() else 1.0
        statistic = f"signed-rank test of the shares' difference over {len(maps)} maps"
        return Finding(statistic, p, "mean difference of shares", mean_over(difference))

    def glance(self, samples: Samples) -> tuple[float, float]:
        """The same test, and the odds ratio."""
        a, b = self._flags(samples)
        only_a, only_b = int((a & ~b).sum()), int((b & ~a).sum())
        return statistics.sign_test(a, b), only_a / only_b if only_b else np.inf if only_a else 1.0

    def says(self, p: float, effect: float) -> int:
        """By the side on which the odds ratio lies, if the difference is significant."""
        return int(np.sign(effect - 1.0)) if p < SIGNIFICANCE else 0

    def _flags(self, samples: Samples) -> tuple[Flags, Flags]:
        return EVENTS[self.event].flags(samples[self.a]), EVENTS[self.event].flags(samples[self.b])
