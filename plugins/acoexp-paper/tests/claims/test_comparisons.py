"""Comparisons of two algorithms, on samples whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.comparisons import Fewer, MoreOften
from made import sample, says
from scipy import stats


def test_fewer_is_seen_its_opposite_too_and_no_difference_is_not() -> None:
    quick, slow, alike = sample(5, seed=1), sample(9, seed=2), sample(5, seed=3)
    claim = Fewer("hitting time", "pd", "aco")
    assert says(claim, pd=quick, aco=slow) == 1
    assert says(claim, pd=slow, aco=quick) == -1
    assert says(claim, pd=quick, aco=alike) == 0


def test_a_trial_that_misses_the_optimum_ranks_behind_all_that_find_it() -> None:
    quick_but_rare, slow_but_sure = sample(5, found=0.2, seed=1), sample(9, seed=2)
    assert says(Fewer("hitting time", "pd", "aco"), pd=quick_but_rare, aco=slow_but_sure) == -1


def test_more_often_is_seen_its_opposite_too_and_no_difference_is_not() -> None:
    sure, rare, alike = sample(converged=0.9, seed=1), sample(converged=0.5, seed=2), sample(converged=0.9, seed=3)
    claim = MoreOften("converged", "pd", "aco")
    assert says(claim, pd=sure, aco=rare) == 1
    assert says(claim, pd=rare, aco=sure) == -1
    assert says(claim, pd=sure, aco=alike) == 0


@pytest.mark.parametrize(("pd", "aco", "ratio"), [(1.0, 0.5, np.inf), (0.5, 1.0, 0.0), (1.0, 1.0, 1.0)])
def test_the_odds_ratio_where_one_never_fails(pd: float, aco: float, ratio: float) -> None:
    _, effect = MoreOften("found", "pd", "aco").p_and_effect({"pd": sample(found=pd), "aco": sample(found=aco)})
    assert effect == ratio


def test_over_maps_each_counts_once() -> None:
    maps = [{"pdg": sample(5, seed=i), "pf": sample(9, seed=i + 50)} for i in range(12)]
    finding = Fewer("hitting time", "pdg", "pf").test_over(maps)
    assert finding.p == pytest.approx(stats.wilcoxon(np.ones(12)).pvalue)
    assert finding.effect.low > 0.9


def test_over_maps_shares_are_compared_by_their_difference() -> None:
    maps = [{"pd": sample(found=0.9, seed=i), "aco": sample(found=0.5, seed=i + 50)} for i in range(12)]
    finding = MoreOften("found", "pd", "aco").test_over(maps)
    assert finding.p == pytest.approx(stats.wilcoxon(np.ones(12)).pvalue)
    assert finding.effect.low < 0.4 < finding.effect.high


@pytest.mark.parametrize("claim", [Fewer("lost ants", "pd", "aco"), MoreOften("found", "pd", "aco")])
def test_over_maps_that_show_no_difference_nothing_is_shown(claim: Fewer | MoreOften) -> None:
    same = sample()
    assert claim.test_over([{"pd": same, "aco": same}] * 3).p == 1.0


def test_a_comparison_is_of_both_algorithms_and_said_in_words() -> None:
    fewer, more = Fewer("lost ants", "pd", "aco"), MoreOften("stuck", "aco", "pdg")
    assert fewer.algos == ("pd", "aco")
    assert fewer.text == "ACO-PD loses fewer ants than standard ACO"
    assert more.text == "standard ACO converges to a local optimum more often than ACO-PDG"
