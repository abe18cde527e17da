"""The pictures: what is drawn is what was measured, in signs that do not need colour."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from acoexp.sensitivity.design import levels
from acoexp.sensitivity.outcomes import Measured
from acoexp.sensitivity.pictures import draw_curves, draw_shares
from acoexp.sensitivity.rows import curve_rows, share_rows
from acoexp.sensitivity.shares import Share, Shares
from acoexp.sensitivity.span import Factor, Span

FACTORS = [Factor("rho", Span(0.1, 0.9, log=True), 0.5), Factor("max_steps", Span(5.0, 9.0), float("nan"))]
KEYS = [factor.key for factor in FACTORS]


@pytest.fixture
def shares(tmp_path: Path) -> str:
    """The picture of shares, of which one outcome has none."""
    part = Share(0.3, 0.2, 0.4)
    one = Shares([part] * 2, [part] * 2, part, part, np.array([0.5, 0.5]))
    rows = share_rows(KEYS, {"gap": one, "cycles": one, "found": None, "lost": one})
    draw_shares(rows, KEYS, tmp_path)
    return (tmp_path / "shares.svg").read_text("utf-8")


def texts(svg: str) -> list[str]:
    """Return the texts that are drawn."""
    return re.findall(r"<!-- (.*?) -->", svg)


def test_each_key_is_named_once_and_an_outcome_that_never_varies_says_so(shares: str) -> None:
    drawn = texts(shares)
    assert [drawn.count(name) for name in (*KEYS, "the same in all trials", "a key alone")] == [1, 1, 1, 1]
    assert {drawn.count("seeds"), drawn.count("several keys together")} == {2}  # an axis and the legend


def test_the_same_numbers_are_the_same_bytes(shares: str, tmp_path: Path) -> None:
    part = Share(0.3, 0.2, 0.4)
    one = Shares([part] * 2, [part] * 2, part, part, np.array([0.5, 0.5]))
    rows = share_rows(KEYS, {"gap": one, "cycles": one, "found": None, "lost": one})
    draw_shares(rows, KEYS, tmp_path)
    assert (tmp_path / "shares.svg").read_text("utf-8") == shares


def test_each_key_has_a_row_of_curves(tmp_path: Path) -> None:
    points = levels(FACTORS)
    zeros = np.zeros(3)
    one = Measured(dict.fromkeys(("gap", "cycles", "found", "lost"), zeros), zeros > 0.0)
    draw_curves(curve_rows(points, [one] * len(points), 0.0), FACTORS, tmp_path)
    svg = (tmp_path / "curves.svg").read_text("utf-8")
    assert svg.count('<g id="axes_') == 4 * len(KEYS)
    assert set(KEYS) <= set(texts(svg))
