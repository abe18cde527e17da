"""A table of texts, and how numbers are written in one: with as many digits as matter, and their interval."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Table(NamedTuple):
    """A table of texts.

    Attributes:
        title: Its title.
        note: What its numbers are.
        headings: One per column.
        rows: Its rows.
    """

    title: str
    note: str
    headings: list[str]
    rows: list[list[str]]


def interval(value: float, low: float, high: float) -> str:
    """Return a number with its interval, such as ``0.60 [0.58, 0.62]``."""
    if np.isnan(low) or np.isnan(high):
        return number(value)
    return f"{number(value)} [{number(low)}, {number(high)}]"


def number(value: float) -> str:
    """Return a number with three digits that matter; a dash where there is none."""
    if np.isnan(value):
        return "-"
    if np.isinf(value):
        return "∞"
    whole = max(1, int(np.floor(np.log10(value))) + 1) if value >= 1.0 else 1
    return f"{value:.{max(0, 3 - whole)}f}"


def p_value(p: float) -> str:
    """Return a p value with three digits."""
    return "< 0.001" if p < 0.001 else f"{p:.3f}"
