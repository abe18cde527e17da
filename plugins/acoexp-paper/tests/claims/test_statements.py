"""Statements about one algorithm, on samples whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.pooling import Over
from acoexp_paper.claims.statements import CountIs, MeanIs, mean_effect, verdict_of_number
from made import sample, verdict

from acoexp.compare.statistics import Estimate


@pytest.mark.parametrize(
    ("printed", "said"), [(5.0, "compatible"), (5.5, "compatible"), (7.0, "contradicted"), (3.0, "contradicted")]
)
def test_a_printed_mean_is_held_against_means_of_ten(printed: float, said: str) -> None:
    assert verdict(MeanIs("x1", "aco", printed), {"aco": sample(5)}) == said


@pytest.mark.parametrize(("printed", "said"), [(3, "compatible"), (5, "compatible"), (10, "contradicted")])
def test_a_printed_count_is_held_against_counts_of_ten(printed: int, said: str) -> None:
    assert verdict(CountIs("found", "aco", printed), {"aco": sample(found=0.4)}) == said


@pytest.mark.parametrize(("share", "said"), [(1.0, "compatible"), (0.9, "compatible"), (0.5, "contradicted")])
def test_every_trial_means_ten_of_ten(share: float, said: str) -> None:
    assert verdict(CountIs("found", "aco", 10), {"aco": sample(found=share)}) == said


def test_over_maps_a_printed_mean_may_be_that_of_any() -> None:
    alike, other = {"aco": sample(5)}, {"aco": sample(9)}
    claim = MeanIs("x1", "aco", 9.0)
    assert verdict(claim, alike, alike, alike) == "contradicted"
    assert verdict(claim, alike, other, alike) == "depends on the map"
    assert verdict(claim, other, other, other) == "compatible"


@pytest.mark.parametrize(
    ("p", "p_between", "on", "said"),
    [
        (0.5, 0.5, 0.5, "compatible"),
        (0.5, 0.001, 0.5, "depends on the map"),
        (0.01, 0.001, 0.5, "depends on the map"),
        (0.5, 0.001, 0.95, "compatible"),
        (0.01, 0.001, 0.05, "contradicted"),
        (0.01, 0.5, 0.5, "contradicted"),
    ],
)
def test_it_depends_on_the_map_only_if_the_maps_differ_and_part_on_the_number(
    p: float, p_between: float, on: float, said: str
) -> None:
    pooled = Over(Estimate(5.0, np.nan, np.nan), (0.0, 10.0), 1.0, 1.0, 20.0, p_between)
    assert verdict_of_number(pooled, p, np.arange(20) < 20 * on) == said


def test_the_effect_is_the_mean_of_what_is_defined_and_the_count_of_ten() -> None:
    share = CountIs("found", "aco", 8).effect({"aco": sample(found=0.5)})
    assert share.value == pytest.approx(5.0, abs=1.0)
    assert mean_effect(np.array([1.0, np.nan, 3.0])).value == 2.0
    assert np.isnan(mean_effect(np.array([np.nan, 3.0])).value)


def test_statements_are_of_one_algorithm_and_said_in_words() -> None:
    assert MeanIs("x1", "pdg", 2.6).algos == ("pdg",)
    assert MeanIs("x1", "pdg", 2.6).text == "ACO-PDG needs 2.6 iterations on average"
    assert CountIs("found", "pd", 8).text == "ACO-PD finds the optimum in 8 of ten trials"
    assert CountIs("steady", "pdg", 10).text == "ACO-PDG has x1 = x2 = x3 in every trial"
    assert CountIs("found", "pd", 8).published("fig13") == 8
