"""A key that is varied and its span, the numbers that it is varied over, written as for a study of Optuna's.

Such as ``interval(0.1,0.9)``, ``tag(log,interval(1,100))``, ``int(interval(10,50))``, ``range(10,50,5)`` and
``choice(1,2,5)``.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

_MOST_VALUES = 1000
"""Values that a range or a choice may have."""
_HIGHEST = 2.0**53
"""Whole numbers are exact as floating-point ones up to here."""

_TAGGED = re.compile(r"tag\(log,(.*)\)")
_CALL = re.compile(r"(interval|int\(interval|range|choice)\(([^()]*)\)(\)?)")
_NUMBER = re.compile(r"[-+]?(\d{1,400}\.?\d{0,400}|\.\d{1,400})([eE][-+]?\d{1,4})?")


@dataclass(frozen=True)
class Span:
    """Numbers from ``low`` to ``high``, both among them, or some of these alone.

    Attributes:
        low: The smallest.
        high: The largest.
        log: Whether they are looked at by their logarithm.
        whole: Whether they are whole numbers.
        values: The only ones, in ascending order; none where any between the ends will do.
    """

    low: float
    high: float
    log: bool = False
    whole: bool = False
    values: tuple[float, ...] = ()

    def at(self, share: float) -> float:
        """Return the number that lies at a share of the span, 0 <= share < 1, each as likely as any other.

        A whole number has the same part of the span as its neighbours, or of its logarithm half a number to each
        side.
        """
        if self.values:
            return self.values[int(share * len(self.values))]
        half = 0.5 if self.whole else 0.0
        low, high = (self._scaled(end) for end in (self.low - half, self.high + half))
        number = low + share * (high - low)
        number = math.exp(number) if self.log else number
        return min(max(float(round(number)) if self.whole else number, self.low), self.high)

    def levels(self, most: int) -> list[float]:
        """Return some of the numbers, evenly spread from end to end; all, where there are few."""
        if self.values:
            places = np.linspace(0, len(self.values) - 1, min(most, len(self.values)))
            return [self.values[round(place)] for place in places]
        spread = np.linspace(self._scaled(self.low), self._scaled(self.high), most)
        inner = [math.exp(number) if self.log else float(number) for number in spread[1:-1]]
        numbers = [self.low, *inner, self.high]
        return sorted({float(round(number)) if self.whole else number for number in numbers})

    def __str__(self) -> str:
        """Return it as a person reads it."""
        if self.values:
            texts = [f"{value:g}" for value in self.values]
            return ", ".join(texts if len(texts) <= 6 else [*texts[:3], "...", texts[-1]])
        return f"{self.low:g} to {self.high:g}" + (", by logarithm" if self.log else "")

    def _scaled(self, number: float) -> float:
        return math.log(number) if self.log else number


class Factor(NamedTuple):
    """One key that is varied.

    Attributes:
        key: As on the command line, such as ``diffusion.gamma``.
        span: What it is varied over.
        value: What the command line says; nan where that is null.
    """

    key: str
    span: Span
    value: float


def parse_span(text: str, whole: bool) -> Span:
    """Return the span that a text describes.

    Args:
        text: Such as ``interval(0.1,0.9)``.
        whole: Whether the key is a whole number.

    Raises:
        ValueError: if it describes none; the message says what was expected.
    """
    text = "".join(text.split())
    tagged = _TAGGED.fullmatch(text)
    found = _CALL.fullmatch(tagged[1] if tagged else text)
    if found is None or bool(found[3]) != found[1].startswith("int("):
        if not tagged and "," in text and "(" not in text:
            return _listed(text, whole)
        raise ValueError("expected numbers, such as interval(0.1,0.9), range(10,50,5) or choice(1,2,5)")
    whole = whole or found[1].startswith("int(")
    if found[1] == "choice" and not tagged:
        return _listed(found[2], whole)
    numbers = _numbers(found[2], whole)
    if found[1] == "range" and not tagged:
        return _range(numbers, whole)
    if len(numbers) != 2 or not numbers[0] < numbers[1] or found[1] in ("range", "choice"):
        raise ValueError("expected interval(low,high), from a number to a larger one")
    if tagged and numbers[0] <= 0.0:
        raise ValueError("expected numbers above 0 with a log")
    low, high = numbers
    return Span(low, high, log=bool(tagged), whole=whole)


def _listed(text: str, whole: bool) -> Span:
    values = tuple(sorted(set(_numbers(text, whole))))
    if not 2 <= len(values) <= _MOST_VALUES:
        raise ValueError(f"expected from 2 to {_MOST_VALUES} different numbers")
    return Span(values[0], values[-1], whole=whole, values=values)


def _range(numbers: list[float], whole: bool) -> Span:
    """Return the numbers of a range, which ends before its stop as everywhere in Hydra."""
    start, stop, step = [*numbers, 1.0][:3] if len(numbers) in (2, 3) else (0.0, 0.0, 0.0)
    steps = (stop - start) / step if step > 0.0 else 0.0
    size = math.ceil(round(steps, 9)) if steps <= _MOST_VALUES else 0
    if size < 2:
        raise ValueError(f"expected range(start,stop,step) with from 2 to {_MOST_VALUES} numbers in it")
    values = tuple(round(start + place * step, 12) for place in range(size))
    return Span(values[0], values[-1], whole=whole, values=values)


def _numbers(text: str, whole: bool) -> list[float]:
    words = text.split(",")
    numbers = [float(word) if _NUMBER.fullmatch(word) else math.nan for word in words[: _MOST_VALUES + 1]]
    if not all(math.isfinite(number) for number in numbers):
        raise ValueError("expected numbers, such as interval(0.1,0.9), range(10,50,5) or choice(1,2,5)")
    if whole and not all(number.is_integer() and abs(number) <= _HIGHEST for number in numbers):
        raise ValueError("expected whole numbers")
    return numbers
