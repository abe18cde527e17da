"""The likelihood, against its formula written out by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from acoexp.grid import path_length
from acoexp.reconstruct.likelihood import log_likelihood, matches, score
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import ENVIRONMENTS

SHORT, LONG = 30.3848, 33.7990


def outcomes(*trials: tuple[int, int, float, float]) -> Outcomes:
    """Return trials given as (x1, x3, l1, l2)."""
    x1, x3, l1, l2 = zip(*trials, strict=True)
    return Outcomes(np.array(x1), np.array(x3), np.array(l1, dtype=float), np.array(l2, dtype=float))


def near(published: int, simulated: int) -> float:
    """The kernel on log cycles, at a published cycle."""

    def bell(cycle: int) -> float:
        return math.exp(-0.5 * (math.log(cycle / simulated) / 0.2) ** 2)

    return 0.95 * bell(published) / sum(bell(cycle) for cycle in range(1, 201)) + 0.05 / 200


def test_one_trial_against_one() -> None:
    expected = math.log(0.95 * 0.95 * near(10, 12) * near(29, 20))
    found = log_likelihood(outcomes((10, 29, SHORT, LONG)), outcomes((12, 20, SHORT, LONG)))
    assert found == pytest.approx(expected)


def test_a_length_of_another_category_costs_a_fixed_factor() -> None:
    expected = math.log(0.95 * 0.01 * near(10, 10) * near(29, 29))
    found = log_likelihood(outcomes((10, 29, SHORT, LONG)), outcomes((10, 29, SHORT, SHORT)))
    assert found == pytest.approx(expected)


def test_simulated_trials_are_averaged_and_published_ones_multiplied() -> None:
    simulated = outcomes((10, 29, SHORT, LONG), (8, 8, SHORT, SHORT))
    first = 0.95 * (0.95 * near(9, 10) * near(30, 29) + 0.01 * near(9, 8) * near(30, 8)) / 2
    second = 0.95 * (0.01 * near(7, 10) * near(7, 29) + 0.95 * near(7, 8) * near(7, 8)) / 2
    found = log_likelihood(outcomes((9, 30, SHORT, LONG), (7, 7, SHORT, SHORT)), simulated)
    assert found == pytest.approx(math.log(first) + math.log(second))


def test_a_trial_in_which_no_ant_arrived_counts_against_the_map() -> None:
    good, lost = outcomes((10, 29, SHORT, LONG)), outcomes((0, 0, math.nan, math.nan))
    assert -40.0 < log_likelihood(good, lost) < log_likelihood(good, good.joined(lost))


def test_a_printed_length_stands_for_one_pair_of_moves() -> None:
    exact = np.array([path_length(12, 13), path_length(14, 14), path_length(13, 13)])
    assert matches(np.array([SHORT, LONG]), exact).tolist() == [[True, False, False], [False, True, False]]


def test_where_no_trial_is_published_what_counts_is_that_ten_trials_find_the_optimum() -> None:
    optimum = path_length(*ENVIRONMENTS["env1"].optimum)
    simulated = outcomes(*[(9, 9, optimum, optimum)] * 3, (9, 9, optimum + 1, optimum + 1))
    assert score(ENVIRONMENTS["env1"], simulated) == pytest.approx(10 * math.log(3.5 / 5))


def test_trials_like_the_published_ones_fit_best() -> None:
    environment = ENVIRONMENTS["fig13"]
    own = environment.trials
    other = replace(environment, name="env2").trials
    assert score(environment, own) > score(environment, own.joined(other)) > score(environment, other)
