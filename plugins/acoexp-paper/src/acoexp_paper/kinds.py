"""Kinds of claims: what each says of trials, the test that fits it, and what the test's outcome says of the claim.

Two algorithms are compared on the same seeds, hence in pairs. Such a claim has to be shown: its null hypothesis is
that there is no difference. A claim about one algorithm alone is its own null hypothesis, and has to be rejected;
correction for many tests would favour it, so it is judged without.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np
from acoexp.report import statistics
from acoexp.report.measures import SIGNIFICANCE, Sample
from acoexp.report.statistics import LEVEL, Estimate, Flags, Values
from scipy import stats

from acoexp_paper.averages import mean_of_ten, values_of
from acoexp_paper.published import TRIALS

Samples = Mapping[str, Sample]

PRACTICALLY_ALL = 0.99
"""The share of trials from which on "every trial" is taken to hold."""

_BEHIND_ALL = 1e9


class Finding(NamedTuple):
    """What a test found.

    Attributes:
        statistic: The test's name, with its numbers.
        p: Its p value, two-sided unless the statistic says otherwise.
        measure: What the effect is: ``A12`` and so on.
        effect: Its size with its interval.
    """

    statistic: str
    p: float
    measure: str
    effect: Estimate


class Kind(ABC):
    """One kind of claim.

    Attributes:
        algos: The algorithms it is about.
        compares: Whether it has to be shown, and its p value corrected.
    """

    algos: tuple[str, ...]
    compares: ClassVar[bool]

    @abstractmethod
    def test(self, samples: Samples) -> Finding:
        """Test the claim on one map."""

    @abstractmethod
    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """Test the claim over many maps, each of which counts once."""

    @abstractmethod
    def glance(self, samples: Samples) -> tuple[float, float]:
        """Return p and effect on one map, without intervals."""

    @abstractmethod
    def says(self, p: float, effect: float) -> int:
        """Return 1 if this supports the claim, -1 if it shows the opposite, 0 if neither."""


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
        return MEASURES[self.measure](a), MEASURES[self.measure](b)


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
        return EVENTS[self.event](samples[self.a]), EVENTS[self.event](samples[self.b])


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

    def test(self, samples: Samples) -> Finding:
        """Fisher's exact test of the paper's ten trials against ours."""
        flags = EVENTS[self.event](samples[self.algo])
        rate = statistics.success_rate(flags)
        statistic = f"Fisher's exact test, {self.printed} of {TRIALS} printed, {int(flags.sum())} of {flags.size} ours"
        return Finding(statistic, self._p(flags), "share of trials", rate)

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same with the trials of all maps together; the interval is over maps."""
        flags = [EVENTS[self.event](samples[self.algo]) for samples in maps]
        shares = np.array([f.mean() for f in flags])
        return Finding(f"Fisher's exact test over {len(maps)} maps", self._p(np.concatenate(flags)), "mean share of trials", mean_over(shares))

    def glance(self, samples: Samples) -> tuple[float, float]:
        """p, and our share."""
        flags = EVENTS[self.event](samples[self.algo])
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

    def test(self, samples: Samples) -> Finding:
        """The one-sided binomial test of a share of at least 99 %, and the share with Wilson's interval."""
        flags = EVENTS[self.event](samples[self.algo])
        statistic = f"binomial test of at least {PRACTICALLY_ALL:.0%}, {int(flags.sum())} of {flags.size}"
        return Finding(statistic, self._p(flags), "share of trials", statistics.success_rate(flags))

    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """The same with the trials of all maps together; the interval is over maps."""
        flags = [EVENTS[self.event](samples[self.algo]) for samples in maps]
        shares = np.array([f.mean() for f in flags])
        statistic = f"binomial test of at least {PRACTICALLY_ALL:.0%} over {len(maps)} maps"
        return Finding(statistic, self._p(np.concatenate(flags)), "mean share of trials", mean_over(shares))

    def glance(self, samples: Samples) -> tuple[float, float]:
        """p, and the share."""
        flags = EVENTS[self.event](samples[self.algo])
        return self._p(flags), float(flags.mean())

    def says(self, p: float, effect: float) -> int:
        """Whether so many exceptions are too many."""
        return int(p >= SIGNIFICANCE)

    def _p(self, flags: Flags) -> float:
        return float(stats.binomtest(int(flags.sum()), flags.size, PRACTICALLY_ALL, alternative="less").pvalue)


def mean_over(effects: Values) -> Estimate:
    """Return the mean of one number per map, with its bootstrap interval over maps."""
    if effects.size < 2 or np.ptp(effects) == 0.0:
        return Estimate(float(effects.mean()), float(effects.min()), float(effects.max()))
    interval = stats.bootstrap(
        (effects,), np.mean, n_resamples=statistics.RESAMPLES, confidence_level=LEVEL,
        method="percentile", random_state=np.random.default_rng(0),
    ).confidence_interval  # fmt: skip
    return Estimate(float(effects.mean()), float(interval.low), float(interval.high))


def _rarity(values: Values, printed: float) -> float:
    """Return the share of means of ten trials that lie as far from the mean of all as the printed one, at least."""
    there = values[~np.isnan(values)]
    if there.size == 0:
        return 0.0

    def means(size: tuple[int, int]) -> Values:
        random = np.random.default_rng(0)
        drawn = values[random.integers(len(values), size=(size[0], 1)), random.integers(values.shape[1], size=(size[0], TRIALS))]
        return np.nanmean(np.where(np.isnan(drawn).all(axis=1, keepdims=True), there.mean(), drawn), axis=1, keepdims=True)

    distance: Callable[..., Values] = lambda x, axis: np.round(np.abs(x - there.mean()), 9).max(axis=axis)  # noqa: E731
    test = stats.monte_carlo_test(np.array([printed]), means, distance, n_resamples=9999, alternative="greater")
    return float(test.pvalue)


def _waiting(sample: Sample) -> Values:
    return np.nan_to_num(sample.features["x2"] - sample.features["x1"], nan=_BEHIND_ALL)


def _hitting_time(sample: Sample) -> Values:
    return sample.hitting_time(sample.iterations + 1)


def _steady(sample: Sample) -> Flags:
    x = sample.features
    return (x["x1"] == x["x2"]) & (x["x2"] == x["x3"])


MEASURES: dict[str, Callable[[Sample], Values]] = {
    "hitting time": _hitting_time,
    "lost ants": lambda sample: sample.features["lost_ants"],
    "l1": lambda sample: np.nan_to_num(sample.features["l1"], nan=_BEHIND_ALL),
    "l2": lambda sample: sample.convergence(_BEHIND_ALL),
    "x2 - x1": _waiting,
    "x3": lambda sample: np.nan_to_num(sample.features["x3"], nan=_BEHIND_ALL),
}
"""What may be smaller; a trial without a value, or that missed the optimum, ranks behind all others."""

EVENTS: dict[str, Callable[[Sample], Flags]] = {
    "found": lambda sample: sample.found,
    "converged": lambda sample: sample.features["l2"] == sample.optimum,
    "stuck": lambda sample: sample.features["l2"] != sample.optimum,
    "steady": _steady,
}
"""What may happen in a trial: it finds the optimum, converges to it, or not, or has x1 = x2 = x3."""
