"""Claims that compare two algorithms, on the same seeds and so in pairs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import scipy  # scipy.stats is imported when first used

from acoexp.compare import statistics
from acoexp.compare.statistics import SIGNIFICANCE, Flags, Values
from acoexp_paper.claims.kinds import Finding, Kind, mean_over
from acoexp_paper.published.tables import NAMES
from acoexp_paper.trials.samples import EVENTS, MEASURES, Samples


@dataclass(frozen=True)
class Comparison(Kind):
    """Trials of one algorithm do better than those of another with the same seeds.

    Attributes:
        what: The measure or event that is compared, by name.
        a: The algorithm that is said to do better.
        b: The other.
        neutral: The effect that speaks for neither.
    """

    what: str
    a: str
    b: str
    compares = True
    neutral: ClassVar[float]

    @property
    def algos(self) -> tuple[str, ...]:
        """Both."""
        return self.a, self.b

    def says(self, p: float, effect: float) -> int:
        """By the side on which the effect lies, if the difference is significant."""
        return int(np.sign(effect - self.neutral)) if p < SIGNIFICANCE else 0


class Fewer(Comparison):
    """Trials of ``a`` have a smaller value than those of ``b``."""

    neutral = 0.5

    @property
    def text(self) -> str:
        """Such as "ACO-PD loses fewer ants than standard ACO"."""
        return f"{NAMES[self.a]} {MEASURES[self.what].smaller} than {NAMES[self.b]}"

    def test(self, samples: Samples) -> Finding:
        """The exact sign test of the pairs, and A12 with its bootstrap interval."""
        a, b = self._values(samples)
        statistic = f"sign test, {int((a < b).sum())} of {a.size} pairs smaller, {int((a > b).sum())} larger"
        return Finding(statistic, statistics.sign_test(a, b), "A12", statistics.superiority(a, b))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """Wilcoxon's signed-rank test of A12 over maps, and its mean."""
        effects = np.array([self.p_and_effect(samples)[1] for samples in maps])
        statistic = f"signed-rank test of A12 over {len(maps)} maps"
        return Finding(statistic, _signed_rank(effects - self.neutral), "mean A12", mean_over(effects))

    def p_and_effect(self, samples: Samples) -> tuple[float, float]:
        """The same test, and A12 from Mann and Whitney's U."""
        a, b = self._values(samples)
        wins = scipy.stats.mannwhitneyu(b, a, method="asymptotic").statistic
        return statistics.sign_test(a, b), float(wins) / (a.size * b.size)

    def _values(self, samples: Samples) -> tuple[Values, Values]:
        values = MEASURES[self.what].values
        return values(samples[self.a]), values(samples[self.b])


class MoreOften(Comparison):
    """Something happens in more trials of ``a`` than of ``b``."""

    neutral = 1.0

    @property
    def text(self) -> str:
        """Such as "ACO-PD finds the optimum more often than standard ACO"."""
        return f"{NAMES[self.a]} {EVENTS[self.what].words} more often than {NAMES[self.b]}"

    def test(self, samples: Samples) -> Finding:
        """McNemar's exact test, and the odds ratio that belongs to it."""
        a, b = self._flags(samples)
        statistic = f"McNemar, {a.mean():.1%} against {b.mean():.1%} of {a.size} trials"
        return Finding(statistic, statistics.sign_test(a, b), "odds ratio", statistics.odds_ratio(a, b))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """Wilcoxon's signed-rank test of the difference in shares over maps, and its mean."""
        shares = np.array([[flags.mean() for flags in self._flags(samples)] for samples in maps])
        difference = shares[:, 0] - shares[:, 1]
        statistic = f"signed-rank test of the shares' difference over {len(maps)} maps"
        return Finding(statistic, _signed_rank(difference), "mean difference of shares", mean_over(difference))

    def p_and_effect(self, samples: Samples) -> tuple[float, float]:
        """The same test, and the odds ratio."""
        a, b = self._flags(samples)
        only_a, only_b = int((a & ~b).sum()), int((b & ~a).sum())
        return statistics.sign_test(a, b), only_a / only_b if only_b else np.inf if only_a else 1.0

    def _flags(self, samples: Samples) -> tuple[Flags, Flags]:
        flags = EVENTS[self.what].flags
        return flags(samples[self.a]), flags(samples[self.b])


def _signed_rank(effects: Values) -> float:
    """Return p of Wilcoxon's test that effects, one per map, lie around 0; 1 if all are 0."""
    return float(scipy.stats.wilcoxon(effects).pvalue) if effects.any() else 1.0
