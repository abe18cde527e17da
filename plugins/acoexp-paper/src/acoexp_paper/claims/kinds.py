"""What a claim is, and a kind of claims: the test that fits it, and what the test's outcome says of the claim.

Two algorithms are compared on the same seeds, hence in pairs. Such a claim has to be shown: its null hypothesis is
that there is no difference. A claim about one algorithm alone is its own null hypothesis, and has to be rejected;
correction for many tests would favour it, so it is judged without.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar, NamedTuple

import numpy as np
import scipy  # scipy.stats is imported when first used

from acoexp.compare.statistics import LEVEL, RESAMPLES, Estimate, Values
from acoexp_paper.trials.samples import Samples


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
        compares: Whether it has to be shown, and its p value corrected.
    """

    compares: ClassVar[bool]

    @property
    @abstractmethod
    def algos(self) -> tuple[str, ...]:
        """The algorithms it is about."""

    @property
    @abstractmethod
    def text(self) -> str:
        """The claim in words."""

    @abstractmethod
    def test(self, samples: Samples) -> Finding:
        """Test the claim on one map."""

    @abstractmethod
    def test_over(self, maps: Sequence[Samples]) -> Finding:
        """Test the claim over many maps, each of which counts once."""

    @abstractmethod
    def p_and_effect(self, samples: Samples) -> tuple[float, float]:
        """Return both numbers of the test on one map, without the interval, which takes most of its time."""

    @abstractmethod
    def says(self, p: float, effect: float) -> int:
        """Return 1 if this supports the claim, -1 if it shows the opposite, 0 if neither."""


class Claim(NamedTuple):
    """One claim.

    Attributes:
        where: Where the paper makes it.
        map: The environment it is about.
        kind: What it says, and how that is tested.
        remark: What the paper says besides.
        fitted: Whether the search for the maps looked at these numbers; then that it holds says little.
    """

    where: str
    map: str
    kind: Kind
    remark: str = ""
    fitted: bool = False

    @property
    def text(self) -> str:
        """The claim in words."""
        words = self.kind.text + (f" ({self.remark})" if self.remark else "")
        return words[0].upper() + words[1:]

    @property
    def key(self) -> str:
        """The claim in words, with its map; no other has the same."""
        return f"{self.map}: {self.text}"


def mean_over(effects: Values) -> Estimate:
    """Return the mean of one number per map, with its bootstrap interval over maps."""
    if effects.size < 2 or np.ptp(effects) == 0.0:
        return Estimate(float(effects.mean()), float(effects.min()), float(effects.max()))
    interval = scipy.stats.bootstrap(
        (effects,), np.mean, n_resamples=RESAMPLES, confidence_level=LEVEL,
        method="percentile", random_state=np.random.default_rng(0),
    ).confidence_interval  # fmt: skip
    return Estimate(float(effects.mean()), float(interval.low), float(interval.high))
