"""Curves over maps: what is drawn is what was counted."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from compared import LOST, sample
from matplotlib.figure import Figure

from acoexp.compare.over_maps import pictures
from acoexp.compare.over_maps.budgets import UNITS, anytime
from acoexp.compare.over_maps.values import MapValues

INF = np.inf


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """Return the figures that would be saved."""
    figures: list[Figure] = []
    monkeypatch.setattr(pictures, "save", lambda figure, folder, name: figures.append(figure))
    return figures


def test_profiles_step_at_each_maps_ratio_and_end_at_the_share_that_has_one(drawn: list[Figure]) -> None:
    gaps, costs = np.array([[0.0, 0.1], [0.2, 0.0]]), np.array([[10.0, 40.0], [INF, 30.0]])
    pictures.draw_profiles(MapValues(["m", "n"], ["a", "b"], gaps, costs), Path())
    lengths, steps = drawn[0].axes
    assert [line.get_xdata().tolist()[:-1] for line in lengths.lines] == [[1.0, 1.2], [1.0, 1.1]]
    assert [line.get_ydata().tolist()[-1] for line in steps.lines] == [0.5, 1.0]
    assert steps.lines[1].get_xdata().tolist()[:2] == [1.0, 4.0]


@pytest.mark.parametrize("gap", [0.0, INF])
def test_profiles_of_configurations_that_are_alike_can_be_drawn(drawn: list[Figure], gap: float) -> None:
    same = np.full((3, 2), gap)
    pictures.draw_profiles(MapValues([*"mno"], ["a", "b"], same, 1.0 + same), Path())
    assert [line.get_ydata()[-1] for line in drawn[0].axes[0].lines] == [float(gap == 0.0)] * 2


@pytest.mark.parametrize("cycles", [1, 8])
def test_budgets_are_drawn_in_both_units_for_trials_of_any_length(drawn: list[Figure], cycles: int) -> None:
    maps = [[sample([[LOST, *[11.0] * 7][-cycles:]] * 3, label, name) for label in "ab"] for name in "mn"]
    reached = [anytime(maps, unit, inference=False) for unit in UNITS]
    pictures.draw_targets(reached, Path())
    pictures.draw_budgets(reached, Path())
    for figure, name in zip(drawn, ("hit", "gap"), strict=True):
        for axes, of_unit in zip(figure.axes, reached, strict=True):
            for line, one in zip(axes.lines, of_unit, strict=True):
                expected = np.where(np.isinf(getattr(one, name)), np.nan, getattr(one, name))
                assert np.array_equal(line.get_ydata(), expected, equal_nan=True)
                assert np.array_equal(line.get_xdata(), one.budgets)
