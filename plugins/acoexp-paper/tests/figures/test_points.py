"""The feature points of a curve."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from acoexp_paper.figures.points import draw_points, telling_trial
from made import sample

from acoexp.compare.sample import Sample


def features(**values: list[float]) -> Sample:
    return replace(sample(), features={name: np.array(column) for name, column in values.items()})


def test_the_trial_is_one_that_leaves_its_best_length_and_whose_points_lie_apart() -> None:
    some = features(x1=[2, 2, 2, 3], x2=[2, 20, 5, 6], x3=[9, 90, 20, 24], l1=[10.0] * 4, l2=[12, 10, 12, 12.0])
    assert telling_trial(some) == 2


def test_without_one_it_is_that_of_the_others_whose_points_lie_farthest_apart() -> None:
    kept = features(x1=[2, 2, np.nan], x2=[2, 4, np.nan], x3=[2, 8, np.nan], l1=[10.0] * 3, l2=[10.0] * 3)
    assert telling_trial(kept) == 1


def test_the_points_stand_at_the_features_of_the_trial() -> None:
    some = replace(sample(), features={"x1": [3.0], "x2": [6.0], "x3": [9.0], "l1": [10.0], "l2": [12.0]})
    (axes,) = draw_points(some, 0).axes
    curve, _, *points = axes.lines
    np.testing.assert_array_equal(curve.get_ydata(), some.curves[0])
    assert [tuple(np.ravel(point.get_data())) for point in points] == [(3, 10), (6, 10), (9, 12)]
    assert [text.get_text() for text in axes.texts] == ["A(x1, l1)", "B(x2, l1)", "C(x3, l2)"]


@pytest.mark.parametrize("x1", [1.0, 200.0])
def test_a_point_at_an_end_of_the_curve_is_drawn(x1: float) -> None:
    some = replace(sample(), features={"x1": [x1], "x2": [x1], "x3": [x1], "l1": [10.0], "l2": [10.0]})
    assert len(draw_points(some, 0).axes[0].texts) == 3
