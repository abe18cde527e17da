"""What a claim is, and a kind of claims: the effect on one map that it is about, and what all maps say of it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar, NamedTuple

from acoexp_paper.claims.pooling import Effect, Over
from acoexp_paper.trials.samples import Samples


class Kind(ABC):
    """One kind of claim.

    Attributes:
        compares: Whether it has to be shown, and its p value corrected; otherwise it is its own null hypothesis.
        measure: What the effect is: ``A12`` and so on.
        bounds: Between which effects lie.
    """

    compares: ClassVar[bool]
    measure: str
    bounds: tuple[float, float]

    @property
    @abstractmethod
    def algos(self) -> tuple[str, ...]:
        """The algorithms it is about."""

    @property
    @abstractmethod
    def text(self) -> str:
        """The claim in words."""

    @abstractmethod
    def effect(self, samples: Samples) -> Effect:
        """Return the effect on one map, and its noise."""

    @abstractmethod
    def p(self, maps: Sequence[Samples], over: Over) -> float:
        """Return the p value of the claim's null hypothesis over maps, of which ``over`` is the pooled effect."""

    @abstractmethod
    def on_side(self, maps: Sequence[Samples], effects: Sequence[Effect]) -> tuple[bool, ...]:
        """Return whether each map is on the paper's side, by its samples or its effect."""

    @abstractmethod
    def verdict(self, maps: Sequence[Samples], over: Over, p: float) -> str:
        """Return the verdict.

        Args:
            maps: The samples on each map.
            over: Their pooled effect.
            p: The p value, corrected if the claim compares.
        """

    @abstractmethod
    def published(self, env: str) -> float | None:
        """Return the effect in the paper's own ten trials; None where it prints none."""


class Claim(NamedTuple):
    """One claim.

    Attributes:
        where: Where the paper makes it.
        map: The environment it is about.
        kind: What it says, and how that is tested.
        remark: What the paper says besides.
        fitted: Whether the search for the maps looked at these numbers; then it is not counted.
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
