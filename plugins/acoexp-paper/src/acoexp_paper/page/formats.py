"""How numbers are written on the page: lengths with four digits, counts and cycles with one."""

from __future__ import annotations

from acoexp.compare.statistics import Estimate


def number(column: str, value: float, digits: int = 1) -> str:
    """Return a value of a column of the paper's, a dash for nan.

    Args:
        column: The column; those of lengths begin with an l and have four digits.
        value: The value.
        digits: How many digits the others have.
    """
    if value != value:
        return "-"
    return f"{value:z.4f}" if column.startswith("l") else f"{value:z.{digits}f}"  # no minus before a zero


def estimate(column: str, estimate: Estimate) -> str:
    """Return a value of a column with its interval."""
    value, low, high = (number(column, number_) for number_ in estimate)
    return f"{value} [{low}, {high}]"


def yes_or_no(flag: bool | None) -> str:
    """Return yes or no, a dash for neither."""
    return "-" if flag is None else "yes" if flag else "no"
