"""Seeds: one whole number for each trial, and ``0-9,20`` for many."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain
from operator import index
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.errors import SettingsError, shown

HIGHEST_SEED = 2**64 - 1
MOST_SEEDS = 1_000_000
"""Trials that one batch may have."""

_RANGES = re.compile(r"\d{1,20}(-\d{1,20})?(,\d{1,20}(-\d{1,20})?)*")


@dataclass(frozen=True)
class Seeds:
    """Seeds of a batch, as ranges in ascending order that neither overlap nor touch.

    Attributes:
        ranges: The ranges.
    """

    ranges: tuple[range, ...]

    def __len__(self) -> int:
        return sum(len(r) for r in self.ranges)

    def __iter__(self) -> Iterator[int]:
        return chain.from_iterable(self.ranges)

    def array(self) -> NDArray[np.uint64]:
        """Return them as an array, uint64[n]."""
        return np.fromiter(self, dtype=np.uint64, count=len(self))

    def __str__(self) -> str:
        """Return the text that :func:`parse_seeds` reads, one for the same seeds in whatever form they came."""
        return ",".join(f"{r[0]}-{r[-1]}" if len(r) > 1 else f"{r[0]}" for r in self.ranges)


def parse_seeds(text: Any) -> Seeds:
    """Return the seeds that a text such as ``0-999`` or ``0-9,20-29,77`` names; a single number is one seed.

    Raises:
        SettingsError: if it names none, one twice, too many, or is no such text.
    """
    is_seed = isinstance(text, int) and not isinstance(text, bool) and 0 <= text <= HIGHEST_SEED
    words = str(text).replace(" ", "") if is_seed or isinstance(text, str) else ""
    if not _RANGES.fullmatch(words):
        raise SettingsError(
            f"seeds: expected whole numbers and ranges, such as 0-999 or 0-9,20; got {shown(text)}"
        )
    ranges = sorted((_range(part) for part in words.split(",")), key=lambda r: r[0])
    merged = [ranges[0]]
    for following in ranges[1:]:
        last = merged[-1]
        if following[0] <= last[-1]:
            raise SettingsError(f"seeds: expected each seed once; got {following[0]} twice in {shown(text)}")
        if following[0] == last[-1] + 1:
            merged[-1] = range(last[0], following[-1] + 1)
        else:
            merged.append(following)
    if sum(r[-1] - r[0] + 1 for r in merged) > MOST_SEEDS:
        raise SettingsError(f"seeds: expected at most {MOST_SEEDS} in one batch; got {shown(text)}")
    return Seeds(tuple(merged))


def check_seed(seed: Any) -> int:
    """Return a seed as a whole number from 0 to 2^64 - 1.

    Raises:
        SettingsError: if it is not one.
    """
    try:
        whole = -1 if isinstance(seed, bool) else index(seed)
    except TypeError:
        whole = -1
    if not 0 <= whole <= HIGHEST_SEED:
        raise SettingsError(f"seed: expected a whole number from 0 to 2^64 - 1; got {shown(seed)}")
    return whole


def _range(part: str) -> range:
    first, _, last = part.partition("-")
    low, high = check_seed(int(first)), check_seed(int(last or first))
    if high < low:
        raise SettingsError(f"seeds: expected a range from low to high, such as 0-9; got {part!r}")
    return range(low, high + 1)
