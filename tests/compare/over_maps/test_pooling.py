"""Effects over maps: a mean with Student's interval, and where the next map's is to be expected."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.stats
from compared import LOST, sample

from acoexp.compare.over_maps.pooling import effect, effect_row, pooled

EFFECTS = np.array([0.5, 0.6, 0.4, 0.7, 0.55, 0.62])


def test_the_interval_of_the_mean_is_students() -> None:
    interval = scipy.stats.ttest_1samp(EFFECTS, 0.5).confidence_interval(0.95)
    found = pooled(EFFECTS).mean
    assert found == pytest.approx((EFFECTS.mean(), interval.low, interval.high))


def test_the_next_map_lies_in_the_prediction_interval_nineteen_times_of_twenty() -> None:
    draw = np.random.default_rng(2)
    maps = draw.normal(0.5, 0.05, (4000, 7))
    inside = [p.next_low < one[-1] < p.next_high for one in maps for p in [pooled(one[:-1])]]
    assert np.mean(inside) == pytest.approx(0.95, abs=0.015)


def test_intervals_end_where_a_probability_does() -> None:
    found = pooled(np.array([1.0, 1.0, 0.2, 1.0, 0.9]))
    assert found.mean.high == found.next_high == 1.0
    assert 0.0 <= found.next_low < found.mean.low


def test_noise_of_seeds_that_is_known_is_no_difference_between_maps() -> None:
    plain, known, all_noise = (pooled(EFFECTS, noise) for noise in (0.0, 0.005, 1.0))
    assert known.spread**2 == pytest.approx(EFFECTS.var(ddof=1) - 0.005)
    assert known.error == pytest.approx(plain.error) == pytest.approx(EFFECTS.std(ddof=1) / 6**0.5)
    assert known.next_high < plain.next_high
    assert all_noise.spread == 0.0
    assert all_noise.error == pytest.approx(6**-0.5)


def test_without_noise_maps_have_the_spread_that_they_were_drawn_with() -> None:
    draw = np.random.default_rng(2)
    noise = draw.uniform(0.0005, 0.005, (2000, 9))
    maps = draw.normal(0.5, 0.1, noise.shape) + draw.normal(0.0, noise**0.5)
    found = [pooled(one, of_seeds, bounds=(-9.0, 9.0)) for one, of_seeds in zip(maps, noise, strict=True)]
    assert np.mean([one.spread**2 for one in found]) == pytest.approx(0.01, rel=0.1)
    assert np.mean([one.mean.low < 0.5 < one.mean.high for one in found]) == pytest.approx(0.95, abs=0.015)


def test_weights_count_as_often_as_maps_that_stand_there_again() -> None:
    weighted = pooled(np.array([0.4, 0.6, 0.8]), weights=np.array([4.0, 1.0, 1.0]))
    assert weighted.mean.value == pytest.approx(np.mean([0.4] * 4 + [0.6, 0.8]))
    assert weighted.maps == pytest.approx(6**2 / 18)
    alike, plain = pooled(EFFECTS, weights=np.full(6, 3.0)), pooled(EFFECTS)
    assert (*alike.mean, alike.error) == pytest.approx((*plain.mean, plain.error))


def test_the_effect_is_the_share_of_pairs_in_which_a_has_the_shorter_path_lost_trials_behind() -> None:
    a, b = (
        sample([[11.0, 10.0], [12.0, LOST], [LOST, LOST]], "a"),
        sample([[12.0, 13.0], [LOST, LOST], [9e9, 11.0]]),
    )
    best = ([10.0, 12.0, np.inf], [12.0, np.inf, 11.0])
    wins = np.mean([(x < y) + 0.5 * (x == y) for x in best[0] for y in best[1]])
    assert effect(a, b) == pytest.approx(wins)
    row = effect_row(a, b)
    assert (row["map"], row["a"], row["b"], row["a12"]) == ("yard", "a", "c", pytest.approx(wins))
    assert row["low"] <= wins <= row["high"]
