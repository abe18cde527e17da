"""Statements about one algorithm, on samples whose truth is known."""

from __future__ import annotations

import pytest
from acoexp_paper.claims.kinds import Kind
from acoexp_paper.claims.statements import CountIs, Every, MeanIs
from made import N, sample, says
from scipy import stats


@pytest.mark.parametrize(("printed", "expected"), [(5.0, 1), (5.5, 1), (7.0, 0), (3.0, 0)])
def test_a_printed_mean_is_held_against_means_of_ten(printed: float, expected: int) -> None:
    assert says(MeanIs("x1", "aco", printed), aco=sample(5)) == expected


@pytest.mark.parametrize(("printed", "expected"), [(3, 1), (5, 1), (10, 0)])
def test_a_printed_count_is_held_against_counts_of_ten(printed: int, expected: int) -> None:
    assert says(CountIs("found", "aco", printed), aco=sample(found=0.4)) == expected


def test_a_printed_count_is_tested_against_all_of_ours() -> None:
    p, share = CountIs("found", "aco", 8).p_and_effect({"aco": sample()})
    assert (p, share) == (pytest.approx(stats.fisher_exact([[8, 2], [N, 0]]).pvalue), 1.0)


@pytest.mark.parametrize(("share", "expected"), [(1.0, 1), (0.9, 0)])
def test_every_trial_means_nearly_every_one(share: float, expected: int) -> None:
    assert says(Every("found", "aco"), aco=sample(found=share)) == expected


def test_over_maps_a_printed_mean_may_be_that_of_any() -> None:
    maps = [{"aco": sample(x1)} for x1 in (5, 9)]
    claim = MeanIs("x1", "aco", 9.0)
    assert claim.says(*claim.p_and_effect(maps[0])) == 0
    assert claim.says(claim.test_over(maps).p, 7.0) == 1


@pytest.mark.parametrize("claim", [CountIs("found", "aco", 5), Every("found", "aco")])
def test_over_maps_trials_are_counted_together_and_shares_lie_between_maps(claim: Kind) -> None:
    maps = [{"aco": sample(found=share)} for share in (0.0, 1.0)]
    finding = claim.test_over(maps)
    assert finding.effect == (0.5, 0.0, 1.0)
    assert finding.p == pytest.approx(claim.test({"aco": sample(found=0.5)}).p, abs=0.2)


@pytest.mark.parametrize(
    ("claim", "statistic"),
    [
        (CountIs("found", "aco", 5), f"Fisher's exact test, 5 of 10 printed, {N} of {N} ours"),
        (Every("found", "aco"), f"binomial test of at least 99%, {N} of {N}"),
        (MeanIs("x1", "aco", 5.0), "Monte Carlo test of ten trials' mean, printed 5"),
    ],
)
def test_a_test_is_named_with_its_numbers(claim: Kind, statistic: str) -> None:
    assert claim.test({"aco": sample()}).statistic == statistic


def test_statements_are_of_one_algorithm_and_said_in_words() -> None:
    assert MeanIs("x1", "pdg", 2.6).algos == ("pdg",)
    assert MeanIs("x1", "pdg", 2.6).text == "ACO-PDG needs 2.6 iterations on average"
    assert CountIs("found", "pd", 8).text == "ACO-PD finds the optimum in 8 of ten trials"
    assert Every("steady", "pdg").text == "ACO-PDG has x1 = x2 = x3 in every trial"
