"""The space of a study: from overrides such as ``rho=interval(0.1,0.9)`` to the values that a job may be told."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal, DecimalException
from itertools import product
from typing import Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import IntervalSweep, Override, RangeSweep

from acoexp.errors import SettingsError, shown

_MOST_COMBINATIONS = 100_000
"""Combinations that a grid may have, all of which are looked at for each trial."""
_HIGHEST_WHOLE = 2**53
"""A study keeps its numbers as floating-point ones, which are exact up to here."""


@dataclass(frozen=True)
class Numbers:
    """Numbers from ``low`` to ``high``, both among them; whole ones if all of these are.

    Attributes:
        low: The smallest.
        high: The largest.
        step: What lies between two of them; None where any number between will do.
        log: Whether they are looked at by their logarithm.
    """

    low: float
    high: float
    step: float | None = None
    log: bool = False

    @property
    def whole(self) -> bool:
        """Whether these are whole numbers."""
        return isinstance(self.low, int) and isinstance(self.high, int)

    @property
    def ends(self) -> tuple[Any, ...]:
        """The smallest and the largest; one value if there is only one."""
        return tuple(dict.fromkeys((self.low, self.high)))

    def __len__(self) -> int:
        """Return how many they are.

        Raises:
            TypeError: if nobody can count them.
        """
        if self.step is None:
            raise TypeError
        return round((self.high - self.low) / self.step) + 1

    def __iter__(self) -> Iterator[Any]:
        """Yield them from the smallest on, as whole steps of it."""
        low, step = Decimal(repr(self.low)), Decimal(repr(self.step))
        kind = int if self.whole else float
        return (kind(low + number * step) for number in range(len(self)))

    def text(self, value: Any) -> str:
        """Return a number as Hydra reads it."""
        return repr(value)


@dataclass(frozen=True)
class Choice:
    """Values that have no order.

    Attributes:
        ends: Each as it is written on the command line.
    """

    ends: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.ends)

    def __iter__(self) -> Iterator[str]:
        return iter(self.ends)

    def text(self, value: str) -> str:
        """Return a value as it is written."""
        return value


class Space:
    """What every job is told, and from what the rest is chosen.

    Attributes:
        fixed: What every job is told.
        keys: What a value is chosen for, each with its values.

    Args:
        overrides: Those of the sweep, the last one of a key counts.

    Raises:
        SettingsError: if a key has no values, or none has several.
    """

    def __init__(self, overrides: Iterable[Override]) -> None:
        self.fixed: list[str] = []
        self.keys: dict[str, Numbers | Choice] = {}
        for override in {override.get_key_element(): override for override in overrides}.values():
            key = override.get_key_element()
            values = _values(override)
            if values is None:
                self.fixed.append(f"{key}={override.get_value_element_as_str()}")
            elif len(values.ends) == 1:
                self.fixed.append(f"{key}={values.text(values.ends[0])}")
            else:
                self.keys[key] = values
        if not self.keys:
            raise SettingsError(
                "hydra/sweeper: optuna expects a key to choose values for, such as rho=interval(0.1,0.9)"
            )

    def told(self, values: Mapping[str, Any]) -> list[str]:
        """Return what a job is told for whom a value of each key was chosen."""
        return [*(f"{key}={self.keys[key].text(value)}" for key, value in values.items()), *self.fixed]

    def plain(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return values that were chosen as what they are: of a text such as ``true``, what Hydra reads."""
        parser = OverridesParser.create()
        chosen = {key: value for key, value in values.items() if isinstance(self.keys.get(key), Choice)}
        return {**values, **{key: parser.parse_override(f"{key}={text}").value() for key, text in chosen.items()}}

    def samples(self) -> list[list[str]]:
        """Return what a few jobs are told who together have each choice and both ends of each interval."""
        longest = max(len(values.ends) for values in self.keys.values())
        return [
            self.told({key: values.ends[min(n, len(values.ends) - 1)] for key, values in self.keys.items()})
            for n in range(longest)
        ]

    def check_countable(self) -> None:
        """Refuse a space of which nobody can try every combination.

        Raises:
            SettingsError: if there are very many of them, or a key is one of an interval.
        """
        size = 1
        for key, values in self.keys.items():
            if isinstance(values, Numbers) and values.step is None:
                raise SettingsError(f"{key}: expected values or a range with hydra/sweeper/sampler=grid")
            size *= len(values)
        if size > _MOST_COMBINATIONS:
            raise SettingsError(
                f"hydra/sweeper/sampler: expected at most {_MOST_COMBINATIONS} combinations with grid; "
                f"got {shown(size)}"
            )

    def combinations(self) -> Iterator[dict[str, Any]]:
        """Yield every combination of values, the last key's changing fastest."""
        for values in product(*self.keys.values()):
            yield dict(zip(self.keys, values, strict=True))


def _values(override: Override) -> Numbers | Choice | None:
    """Return the values that an override leaves the choice of; None if it says one."""
    sweep: Any = override.value()
    if not override.is_sweep_override():
        return None
    if isinstance(sweep, IntervalSweep):
        values = _interval(override, sweep)
    elif isinstance(sweep, RangeSweep):
        values = _range(override, sweep)
    else:
        texts = dict.fromkeys(override.sweep_string_iterator())
        if not texts:
            raise SettingsError(f"{_said(override)}: expected at least one value")
        return Choice(tuple(texts))
    if values.whole and max(-values.low, values.high) > _HIGHEST_WHOLE:
        raise SettingsError(f"{_said(override)}: expected whole numbers of at most {_HIGHEST_WHOLE}")
    if values.log and values.low <= 0:
        raise SettingsError(f"{_said(override)}: expected numbers above 0 with a log")
    return values


def _interval(override: Override, sweep: IntervalSweep) -> Numbers:
    low, high = sweep.start, sweep.end
    if low is None or high is None or not (math.isfinite(low) and math.isfinite(high) and low <= high):
        raise SettingsError(
            f"{_said(override)}: expected interval(low,high), from a number to one that is no smaller"
        )
    whole = isinstance(low, int) and isinstance(high, int)
    return Numbers(low, high, step=1 if whole and "log" not in sweep.tags else None, log="log" in sweep.tags)


def _range(override: Override, sweep: RangeSweep) -> Numbers:
    """Return the numbers of a range, which ends before its stop as everywhere in Hydra."""
    given: Sequence[Any] = (sweep.start, sweep.stop, sweep.step)
    try:
        start, stop, step = (Decimal(repr(number)) for number in given)
        number = math.ceil((stop - start) / step)
        low, high = sorted((start, start + (number - 1) * step))
    except (DecimalException, ArithmeticError, ValueError):
        number = 0
    if number < 1:
        raise SettingsError(f"{_said(override)}: expected range(start,stop,step) with at least one number in it")
    log = "log" in sweep.tags
    if log and step != 1:
        raise SettingsError(f"{_said(override)}: expected a range by steps of 1 with a log")
    kind = int if all(isinstance(one, int) for one in given) else float
    return Numbers(kind(low), kind(high), step=kind(abs(step)), log=log)


def _said(override: Override) -> str:
    """Return an override as it was typed; of a long one its beginning."""
    line = str(override.input_line)
    return line if len(line) <= 100 else shown(line)
