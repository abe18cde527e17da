"""Claims that compare two algorithms, on the same seeds and so in pairs; each has to be shown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from acoexp.compare.statistics import SIGNIFICANCE, Flags, Values, a12
from acoexp_paper.claims.kinds import Kind
from acoexp_paper.claims.pooling import Effect, Over, effect_of
from acoexp_paper.claims.words import CONTRADICTED, DEPENDS, SHOWN, UNDECIDED
from acoexp_paper.published.rows import PRINTED_EVENTS, PRINTED_MEASURES
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

    def p(self, maps: Sequence[Samples], over: Over) -> float:
        """That of no effect on the maps' mean."""
        return over.p_against(self.neutral)

    def on_side(self, maps: Sequence[Samples], effects: Sequence[Effect]) -> tuple[bool, ...]:
        """Those on which ``a`` does better."""
        return tuple(effect.value > self.neutral for effect in effects)

    def verdict(self, maps: Sequence[Samples], over: Over, p: float) -> str:
        """That of :func:`verdict_of`."""
        return verdict_of(over, self.neutral, p)


def verdict_of(over: Over, neutral: float, p: float) -> str:
    """Return the verdict of an effect over maps.

    It depends on the map if the maps differ and the next one's effect may lie on either side; otherwise it is
    shown, or contradicted, by the side of a mean that is significant.
    """
    if over.differ and over.next is not None and over.next[0] < neutral < over.next[1]:
        return DEPENDS
    if p < SIGNIFICANCE:
        return SHOWN if over.mean.value > neutral else CONTRADICTED
    return UNDECIDED


class Fewer(Comparison):
    """Trials of ``a`` have a smaller value than those of ``b``."""

    measure = "A12"
    bounds = (0.0, 1.0)
    neutral = 0.5

    @property
    def text(self) -> str:
        """Such as "ACO-PD loses fewer ants than standard ACO"."""
        return f"{NAMES[self.a]} {MEASURES[self.what].smaller} than {NAMES[self.b]}"

    def effect(self, samples: Samples) -> Effect:
        """A12."""
        values = MEASURES[self.what].values
        return superiority(values(samples[self.a]), values(samples[self.b]))

    def published(self, env: str) -> float | None:
        """A12 of the printed rows."""
        printed = [PRINTED_MEASURES[self.what](env, algo) for algo in self.algos if self.what in PRINTED_MEASURES]
        a, b = printed or (None, None)
        return None if a is None or b is None else float(a12(a, b))


def superiority(a: Values, b: Values) -> Effect:
    """Return A12 of paired trials with its variance (DeLong, DeLong, Clarke-Pearson 1988).

    Args:
        a: Measurements of which smaller ones are better, float[n].
        b: Those of the other algorithm with the same seeds, float[n].
    """
    a_wins, b_loses = _share_behind(a, b), 1.0 - _share_behind(b, a)
    return effect_of(a_wins + b_loses - a_wins.mean(), width=1.0)


def _share_behind(values: Values, others: Values) -> Values:
    """Return what share of the others each value is smaller than, ties counted half, float[n]."""
    in_order = np.sort(others)
    up_to, below = (np.searchsorted(in_order, values, side) for side in ("right", "left"))
    return 1.0 - (up_to + below) / (2.0 * others.size)


class MoreOften(Comparison):
    """Something happens in more trials of ``a`` than of ``b``."""

    measure = "difference in shares"
    bounds = (-1.0, 1.0)
    neutral = 0.0

    @property
    def text(self) -> str:
        """Such as "ACO-PD finds the optimum more often than standard ACO"."""
        return f"{NAMES[self.a]} {EVENTS[self.what].words} more often than {NAMES[self.b]}"

    def effect(self, samples: Samples) -> Effect:
        """The share of ``a``'s trials without that of ``b``'s."""
        flags = EVENTS[self.what].flags
        return difference(flags(samples[self.a]), flags(samples[self.b]))

    def published(self, env: str) -> float | None:
        """The difference of the printed shares."""
        a, b = (PRINTED_EVENTS[self.what](env, algo) for algo in self.algos)
        return None if a is None or b is None else float(a.mean() - b.mean())


def difference(a: Flags, b: Flags) -> Effect:
    """Return the difference in shares of paired trials with its variance."""
    return effect_of(a.astype(float) - b.astype(float), width=2.0)
