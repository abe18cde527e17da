"""Claims about one algorithm: a printed mean, or how many of the paper's ten trials did something.

Such a claim is its own null hypothesis, and has to be rejected; correction for many tests would favour it, so it
is judged without.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from acoexp.compare.statistics import SIGNIFICANCE, Values
from acoexp_paper.claims.kinds import Kind
from acoexp_paper.claims.means import rarity
from acoexp_paper.claims.pooling import Effect, Over, effect_of
from acoexp_paper.claims.words import COMPATIBLE, CONTRADICTED, DEPENDS
from acoexp_paper.published.tables import NAMES, TRIALS
from acoexp_paper.trials.samples import EVENTS, Samples, values_of

_ON_SOME, _ON_MOST = 0.1, 0.9


@dataclass(frozen=True)
class Statement(Kind):
    """The paper prints a number: of ten trials of one algorithm.

    Attributes:
        what: The column or event that it is of, by name.
        algo: The algorithm.
        printed: The number.
    """

    what: str
    algo: str
    printed: float
    compares = False

    @property
    def algos(self) -> tuple[str, ...]:
        """The one."""
        return (self.algo,)

    @abstractmethod
    def values(self, samples: Samples) -> Values:
        """Return the values of our trials whose mean of ten is printed, float[n]; nan where there is none."""

    def p(self, maps: Sequence[Samples], over: Over) -> float:
        """How often the mean of ten of our trials, on a map that is drawn too, lies as far off as the printed."""
        return rarity([self.values(samples) for samples in maps], self.printed)

    def verdict(self, maps: Sequence[Samples], over: Over, p: float) -> str:
        """That of :func:`verdict_of_number`."""
        return verdict_of_number(over, p, self.on_side(maps, ()))

    def on_side(self, maps: Sequence[Samples], effects: Sequence[Effect]) -> tuple[bool, ...]:
        """Those on which ten trials may well have the printed number."""
        return compatible_on([self.values(samples) for samples in maps], self.printed)

    def published(self, env: str) -> float:
        """The printed number."""
        return self.printed


def compatible_on(maps: Sequence[Values], printed: float) -> tuple[bool, ...]:
    """Return whether ten trials on each map may well have the printed number, by the values of its trials."""
    return tuple(rarity([values], printed) >= SIGNIFICANCE for values in maps)


def verdict_of_number(over: Over, p: float, compatible: Sequence[bool]) -> str:
    """Return the verdict of a printed number.

    It depends on the map if the maps differ, and some would have the number and others hardly.

    Args:
        over: The effect over maps.
        p: How rare the printed number is.
        compatible: Whether ten trials on each map may well have it.
    """
    if over.differ and _ON_SOME <= float(np.mean(compatible)) <= _ON_MOST:
        return DEPENDS
    return COMPATIBLE if p >= SIGNIFICANCE else CONTRADICTED


@dataclass(frozen=True)
class MeanIs(Statement):
    """The mean of a column over ten trials is what the paper prints."""

    measure = "mean"
    bounds = (0.0, np.inf)

    @property
    def text(self) -> str:
        """Such as "ACO-PDG needs 2.6 iterations on average"."""
        return f"{NAMES[self.algo]} needs {self.printed:g} iterations on average"

    def values(self, samples: Samples) -> Values:
        """The column."""
        return values_of(samples[self.algo], self.what)

    def effect(self, samples: Samples) -> Effect:
        """Our mean."""
        return mean_effect(self.values(samples))


def mean_effect(values: Values) -> Effect:
    """Return the mean of what is not nan with its variance; nan of less than two."""
    known = values[~np.isnan(values)]
    return effect_of(known, width=1.0) if known.size > 1 else Effect(np.nan, np.nan)


@dataclass(frozen=True)
class CountIs(Statement):
    """Something happened in so many of the paper's ten trials."""

    measure = "of ten trials"
    bounds = (0.0, float(TRIALS))

    @property
    def text(self) -> str:
        """Such as "ACO-PD finds the optimum in 8 of ten trials", or in every trial."""
        how_often = "every trial" if self.printed == TRIALS else f"{self.printed:g} of ten trials"
        return f"{NAMES[self.algo]} {EVENTS[self.what].words} in {how_often}"

    def values(self, samples: Samples) -> Values:
        """Ten where it happens, so that a mean of ten is a count of ten."""
        return EVENTS[self.what].flags(samples[self.algo]).astype(np.float64) * TRIALS

    def effect(self, samples: Samples) -> Effect:
        """Ours of ten."""
        return effect_of(self.values(samples), width=float(TRIALS))
