"""The designs: what is varied in each, and how evenly."""

from __future__ import annotations

import numpy as np

from acoexp.sensitivity.design import levels, saltelli
from acoexp.sensitivity.span import Factor, Span

FACTORS = [
    Factor("rho", Span(0.0, 1.0), 0.3),
    Factor("ants", Span(1.0, 3.0, whole=True), 2.0),
    Factor("max_steps", Span(10.0, 20.0, values=(10.0, 20.0)), float("nan")),
]


def test_a_curve_goes_through_the_command_lines_value_if_there_is_one() -> None:
    points = levels(FACTORS)
    by_key = {factor.key: [value for key, value in points if key == factor.key] for factor in FACTORS}
    assert by_key["rho"] == [0.0, 0.125, 0.25, 0.3, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0]
    assert by_key["ants"] == [1.0, 2.0, 3.0]
    assert by_key["max_steps"] == [10.0, 20.0]


def test_each_further_sample_is_the_first_with_one_column_of_the_second() -> None:
    n = 16
    points = saltelli(FACTORS, n)
    a, b, *mixed = (points[place : place + n] for place in range(0, len(points), n))
    assert len(mixed) == len(FACTORS)
    for factor, sample in zip(FACTORS, mixed, strict=True):
        assert sample == [{**first, factor.key: second[factor.key]} for first, second in zip(a, b, strict=True)]


def test_the_first_two_samples_fill_the_spans_evenly() -> None:
    points = saltelli(FACTORS, 64)
    for sample in (points[:64], points[64:128]):
        counts, _ = np.histogram([point["rho"] for point in sample], bins=64, range=(0.0, 1.0))
        assert counts.tolist() == [1] * 64  # one in each 64th, which points by chance would not be
        assert {point["ants"] for point in sample} == {1.0, 2.0, 3.0}


def test_it_is_the_same_each_time() -> None:
    assert saltelli(FACTORS, 8) == saltelli(FACTORS, 8)
