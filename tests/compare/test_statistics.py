"""Statistics against values worked out by hand or in another way."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.stats import beta

from acoexp.compare import statistics

RANDOM = np.random.default_rng(1)
A = RANDOM.integers(0, 6, 60).astype(np.float64)
B = A + RANDOM.integers(-1, 3, 60)


def flags(*counts: tuple[int, bool]) -> np.ndarray:
    """Return flags, so many of each."""
    return np.array([flag for number, flag in counts for _ in range(number)])


def test_a_mean_leaves_out_what_is_not_there() -> None:
    assert statistics.mean_and_deviation(np.array([1.0, np.nan, 3.0])) == (2.0, pytest.approx(math.sqrt(2.0)))
    assert all(map(math.isnan, statistics.mean_and_deviation(np.array([np.nan, np.nan]))))
    mean, deviation = statistics.mean_and_deviation(np.array([4.0, np.nan]))
    assert mean == 4.0
    assert math.isnan(deviation)


def test_wilsons_interval() -> None:
    z, n, p = 1.959963984540054, 10, 0.8
    centre, half = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    low, high = ((centre + sign * half) / (1 + z * z / n) for sign in (-1, 1))
    assert statistics.success_rate(flags((8, True), (2, False))) == pytest.approx((0.8, low, high))


def test_the_expected_running_time_counts_the_cycles_of_failures() -> None:
    cycles, found = np.array([5.0, 10.0, 20.0, 20.0]), np.array([True, True, False, False])
    time = statistics.expected_running_time(cycles, found)
    assert time.value == pytest.approx(27.5)
    assert time.low == pytest.approx(5.0, abs=5.0)  # four successes of 5 to 10 cycles
    assert time.low < time.value < time.high


def test_the_expected_running_time_without_success_is_infinite() -> None:
    time = statistics.expected_running_time(np.full(5, 20.0), np.zeros(5, dtype=bool))
    assert time.value == time.high == math.inf
    assert math.isnan(time.low)


def test_a_bootstrap_interval_that_reaches_no_success_ends_at_infinity() -> None:
    time = statistics.expected_running_time(np.full(4, 20.0), np.array([True, False, False, False]))
    assert time.value == 80.0
    assert time.high == math.inf


def test_a12_is_the_share_of_pairs_that_a_wins() -> None:
    wins = np.mean([(x < y) + 0.5 * (x == y) for x in A for y in B])
    estimate = statistics.superiority(A, B)
    assert estimate.value == pytest.approx(wins)
    assert estimate.low < wins < estimate.high
    assert statistics.superiority(B, A).value == pytest.approx(1.0 - wins)


def test_the_interval_of_a12_is_that_of_a_bootstrap_over_pairs() -> None:
    draw = np.random.default_rng(5)
    beats = (A[:, None] < B) + 0.5 * (A[:, None] == B)
    resampled = [beats[np.ix_(i, i)].mean() for i in (draw.integers(0, A.size, A.size) for _ in range(4000))]
    estimate = statistics.superiority(A, B)
    assert (estimate.low, estimate.high) == pytest.approx(np.percentile(resampled, (2.5, 97.5)), abs=0.01)


def test_intervals_are_the_same_at_every_call() -> None:
    assert statistics.superiority(A, B) == statistics.superiority(A, B)


def test_the_odds_ratio_counts_pairs_in_which_one_alone_succeeded() -> None:
    a = flags((3, True), (6, True), (2, False), (4, False))
    b = flags((3, True), (6, False), (2, True), (4, False))
    low, high = beta.ppf(0.025, 6, 3), beta.ppf(0.975, 7, 2)  # Clopper, Pearson 1934
    assert statistics.odds_ratio(a, b) == pytest.approx((3.0, low / (1 - low), high / (1 - high)))
    assert statistics.sign_test(a, b) == pytest.approx(2 * (1 + 8 + 28) / 2**8)


def test_without_pairs_that_differ_there_is_nothing_to_tell() -> None:
    same = flags((3, True), (2, False))
    ratio = statistics.odds_ratio(same, same)
    assert math.isnan(ratio.value)
    assert ratio[1:] == (0.0, math.inf)
    assert statistics.sign_test(same, same) == statistics.sign_test(A, A) == 1.0


def test_one_that_always_succeeds_alone_has_infinite_odds() -> None:
    ratio = statistics.odds_ratio(flags((5, True)), flags((5, False)))
    assert ratio.value == ratio.high == math.inf
    assert 0.0 < ratio.low < math.inf


def test_eight_pairs_that_all_point_one_way() -> None:
    better = np.zeros(8)
    assert statistics.sign_test(better, np.arange(1.0, 9.0)) == pytest.approx(2 / 2**8)
    assert statistics.sign_test(np.arange(1.0, 9.0), better) == pytest.approx(2 / 2**8)


def test_ties_and_how_far_a_loser_lies_behind_change_nothing() -> None:
    a, b = np.array([1.0, 1.0, 2.0, 5.0, 5.0]), np.array([2.0, 3.0, 3.0, 4.0, 5.0])
    assert statistics.sign_test(a, b) == statistics.sign_test(a, np.where(b > a, 1e6, b)) == 2 * (1 + 4) / 2**4


def test_holm_steps_down_and_keeps_the_order() -> None:
    assert statistics.holm([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])
    assert statistics.holm([0.6, 0.7]) == [1.0, 1.0]
