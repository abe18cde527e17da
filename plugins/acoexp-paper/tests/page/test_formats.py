"""How numbers are written."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.page.formats import estimate, number, yes_or_no

from acoexp.compare.statistics import Estimate


@pytest.mark.parametrize(
    ("column", "value", "text"),
    [("l1", 30.38478, "30.3848"), ("l_bar", 30.0, "30.0000"), ("n_bar", 2.64, "2.6"), ("x1", np.nan, "-")],
)
def test_lengths_have_four_digits_and_the_others_one(column: str, value: float, text: str) -> None:
    assert number(column, value) == text


def test_the_cycles_of_a_single_trial_have_no_digits() -> None:
    assert (number("x1", 7.0, 0), number("l1", 7.0, 0)) == ("7", "7.0000")


def test_before_a_zero_there_is_no_minus() -> None:
    assert (number("a12", -0.004, 2), number("a12", -0.006, 2), number("l1", -0.0)) == ("0.00", "-0.01", "0.0000")


def test_an_estimate_stands_with_its_interval() -> None:
    assert estimate("x1", Estimate(7.06, 4.1, np.nan)) == "7.1 [4.1, -]"


def test_neither_yes_nor_no_is_a_dash() -> None:
    assert [yes_or_no(flag) for flag in (True, False, None)] == ["yes", "no", "-"]
