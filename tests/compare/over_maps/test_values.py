"""One value for each map and configuration: the trial in the middle, and what comes close costs."""

from __future__ import annotations

import math

import pytest
from compared import LOST, sample

from acoexp.compare.over_maps.values import expected_cost, median_gap, values_of_maps


def test_the_gap_is_that_of_the_trial_in_the_middle_after_its_best_cycle() -> None:
    assert median_gap(sample([[10.0, 15.0], [12.0, 11.0], [20.0, 30.0]])) == pytest.approx(0.1)


def test_of_two_in_the_middle_it_is_the_better_one() -> None:
    assert median_gap(sample([[10.0], [11.0], [12.0], [13.0]])) == pytest.approx(0.1)


def test_lost_trials_count_as_worst() -> None:
    assert median_gap(sample([[LOST], [10.0], [12.0]])) == pytest.approx(0.2)
    assert median_gap(sample([[LOST], [LOST], [10.0]])) == math.inf


def test_an_optimum_is_a_gap_of_nothing_exactly() -> None:
    optimum = 12 + 13 * math.sqrt(2.0)
    assert median_gap(sample([[optimum]] * 3, optimum=optimum)) == 0.0


def test_the_cost_counts_the_steps_of_trials_that_never_came_close() -> None:
    steps = [[5, 7, 9], [1, 1, 1], [10, 20, 30]]
    curves = [[20.0, 10.1, 10.0], [LOST, LOST, LOST], [10.05, 9e9, 9e9]]
    assert expected_cost(sample(curves, steps=steps)) == ((5 + 7) + 3 + 10) / 2
    assert expected_cost(sample([[11.0, 11.0]])) == math.inf


def test_values_stand_map_by_map_in_rows() -> None:
    samples = [sample([[length]], label, name) for name, *lengths in (("a", 10.0, 11.0), ("b", 12.0, LOST))
               for label, length in zip("xy", lengths, strict=True)]  # fmt: skip
    values = values_of_maps([samples[:2], samples[2:]])
    assert (values.maps, values.configurations) == (["a", "b"], ["x", "y"])
    assert values.gaps.tolist() == [[0.0, 0.1], [0.2, math.inf]]
    assert [(row["map"], row["cell"]) for row in values.rows()] == [("a", "x"), ("a", "y"), ("b", "x"), ("b", "y")]
    assert values.rows()[3] == {"map": "b", "cell": "y", "gap": math.inf, "ant_steps": math.inf}
