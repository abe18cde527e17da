"""Where means of ten trials fall."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.means import mean, mean_of_ten, rarity
from scipy import stats

COIN = np.repeat([0.0, 1.0], 500)


def test_the_mean_of_ten_falls_where_the_binomial_distribution_says() -> None:
    share = mean_of_ten([COIN], scale=10)
    assert (share.value, share.low, share.high) == (5.0, *stats.binom(10, 0.5).interval(0.95))


def test_it_falls_in_the_interval_in_95_percent_of_cases() -> None:
    values = np.random.default_rng(1).normal(3.0, 1.0, 4000)
    spread = 1.96 * values.std() / np.sqrt(10)
    interval = mean_of_ten([values])
    assert (interval.low, interval.high) == pytest.approx(
        (values.mean() - spread, values.mean() + spread), abs=0.03
    )


def test_over_maps_the_mean_of_ten_is_that_on_one_of_them() -> None:
    spread = mean_of_ten([np.full(50, 1.0), np.full(50, 3.0)])
    assert (spread.value, spread.low, spread.high) == (2.0, 1.0, 3.0)


def test_what_is_undefined_is_left_out() -> None:
    assert mean_of_ten([np.array([np.nan, 2.0])])[:2] == (2.0, 2.0)
    assert np.isnan(mean_of_ten([np.array([np.nan, np.nan])])).all()
    assert mean(np.array([1.0, np.nan, 3.0])) == 2.0
    assert np.isnan(mean(np.array([np.nan])))


@pytest.mark.parametrize("heads", range(11))
def test_how_rare_a_mean_is_is_the_two_sided_binomial_p(heads: int) -> None:
    assert rarity([COIN], heads / 10) == pytest.approx(stats.binomtest(heads, 10).pvalue, abs=0.02)


def test_over_maps_a_mean_is_as_rare_as_the_maps_on_which_it_lies_so_far_off() -> None:
    maps = [np.full(50, value) for value in (1.0, 2.0, 2.0, 3.0)]
    assert rarity(maps, 3.0) == pytest.approx(0.5, abs=0.02)
    assert rarity(maps, 2.0) == 1.0


def test_each_map_counts_once_however_many_trials_it_has() -> None:
    maps = [np.full(1000, 1.0), np.full(10, 3.0)]
    assert mean_of_ten(maps).value == 2.0
    assert rarity(maps, 3.0) == 1.0


def test_a_printed_mean_of_what_never_happens_has_no_chance() -> None:
    assert rarity([np.full(5, np.nan)], 3.0) == 0.0
