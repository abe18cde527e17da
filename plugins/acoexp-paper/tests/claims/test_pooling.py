"""Effects over maps: the random-effects model, and whether maps differ at all."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.pooling import Effect, Over, effect_of, over
from scipy import stats
from statsmodels.stats.meta_analysis import combine_effects

EVERYWHERE = (-np.inf, np.inf)
EFFECTS = [Effect(value, 0.01) for value in (0.5, 0.9, 0.4, 0.7, 0.55, 0.62)]


def test_of_equally_well_known_maps_it_is_the_model_of_another_library() -> None:
    values, noise = np.array(EFFECTS).T
    other = combine_effects(values, noise, method_re="iterated", use_t=True)
    ours = over(EFFECTS, EVERYWHERE)
    assert ours.spread**2 == pytest.approx(other.tau2)
    assert ours.error == pytest.approx(other.sd_eff_w_re_hksj)
    assert ours.mean[1:] == pytest.approx(other.conf_int()[3])
    assert ours.p_between == pytest.approx(other.test_homogeneity().pvalue)


def test_the_next_map_lies_farther_off_than_the_mean_by_the_spread_alone() -> None:
    found = over(EFFECTS, EVERYWHERE)
    reach = float(stats.t.ppf(0.975, 5)) * (found.spread**2 + found.error**2) ** 0.5
    assert found.next == pytest.approx((found.mean.value - reach, found.mean.value + reach))


def test_one_map_is_known_as_well_as_its_seeds_allow() -> None:
    found = over([Effect(0.9, 0.01)], (0.0, 1.0))
    assert found.mean == pytest.approx((0.9, 0.9 - 1.959964 * 0.1, 1.0))
    assert (found.next, found.p_between, found.differ) == (None, 1.0, False)
    assert found.p_against(0.5) == pytest.approx(2 * stats.norm.sf(4.0))


def test_the_mean_is_held_against_no_effect_by_students_test() -> None:
    found = over([Effect(effect.value, 0.0) for effect in EFFECTS], EVERYWHERE)
    assert found.p_against(0.5) == pytest.approx(stats.ttest_1samp([e.value for e in EFFECTS], 0.5).pvalue)
    assert found.p_against(found.mean.value) == 1.0


def test_weights_shift_the_mean_and_leave_fewer_maps() -> None:
    found = over(EFFECTS, EVERYWHERE, np.array([0.0, 0.5, 0.0, 0.5, 0.0, 0.0]))
    assert (found.mean.value, found.maps) == (pytest.approx(0.8), pytest.approx(2.0))


@pytest.mark.parametrize("noise", [np.full(12, 0.04), np.array([0.001] + [0.04] * 11)])
def test_equal_maps_differ_in_one_case_of_a_hundred_however_well_each_is_known(noise: np.ndarray) -> None:
    draw = np.random.default_rng(1).normal(0.5, noise**0.5, (1500, 12))
    differ = [over(list(map(Effect, values, noise)), EVERYWHERE).differ for values in draw]
    assert np.mean(differ) == pytest.approx(0.01, abs=0.008)


def test_what_all_pairs_say_alike_has_a_noise_too_which_the_number_of_pairs_takes_away() -> None:
    few, many = effect_of(np.ones(10), 1.0), effect_of(np.ones(100), 1.0)
    assert few.value == many.value == 1.0
    assert few.noise > many.noise > 0.0


def test_of_many_pairs_it_is_the_variance_of_their_mean() -> None:
    says = np.random.default_rng(1).random(10_000)
    assert effect_of(says, 1.0).noise == pytest.approx(says.var(ddof=1) / says.size, rel=1e-3)


def test_without_any_noise_only_different_effects_differ() -> None:
    def differ(*values: float) -> bool:
        found: Over = over([Effect(value, 0.0) for value in values], EVERYWHERE)
        return found.differ

    assert differ(0.5, 0.6)
    assert not differ(0.5, 0.5)
