"""A sample: how far each trial is from the optimum after each cycle, and when it hit it."""

from __future__ import annotations

import math

import numpy as np
from compared import LOST, sample


def test_gaps_are_those_of_the_best_path_so_far_and_infinite_before_there_is_one() -> None:
    found = sample([[LOST, 12.0, 15.0, 11.0], [LOST] * 4]).gaps
    assert found.tolist() == [[math.inf, 0.2, 0.2, 0.1], [math.inf] * 4]


def test_a_gap_is_the_number_that_a_person_takes_it_for() -> None:
    optimum = 10 + 10 * math.sqrt(2.0)
    assert sample([[1.1 * optimum, 1.01 * optimum, optimum]], optimum=optimum).gaps.tolist() == [[0.1, 0.01, 0.0]]


def test_what_missed_the_optimum_is_censored() -> None:
    one = sample([[10.0, 12.0], [11.0, LOST]])
    assert one.iterations == 2
    assert one.hitting_time(99).tolist() == [1.0, 99.0]
    assert np.array_equal(one.convergence(50.0), [12.0, 50.0])
