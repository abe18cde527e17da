"""Kinds of claims on samples whose truth is known, and verdicts over maps."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.averages import mean_of_ten
from acoexp_paper.claims import CLAIMS
from acoexp_paper.comparisons import Fewer, MoreOften
from acoexp_paper.kinds import Kind
from acoexp_paper.statements import CountIs, Every, MeanIs
from acoexp_paper.verdicts import corrected_p, verdict_over
from scipy import stats

from acoexp.compare.measures import Sample

N = 400


def sample(x1: int = 5, found: float = 1.0, converged: float = 1.0, seed: int = 0) -> Sample:
    """Return trials around x1, of which such shares find and keep the optimum, 10."""
    random = np.random.default_rng(seed)
    first = random.integers(x1 - 2, x1 + 3, N).astype(float)
    l1 = np.where(random.random(N) < found, 10.0, 11.0)
    l2 = np.where(random.random(N) < converged, l1, 12.0)
    features = {"x1": first, "x2": first, "x3": first, "l1": l1, "l2": l2, "lost_ants": first}
    return Sample("", "map", 10.0, l1 == 10.0, features, np.tile(l2[:, None], (1, 50)))


def says(kind: Kind, **samples: Sample) -> int:
    finding = kind.test(samples)
    glance = kind.glance(samples)
    assert glance == pytest.approx((finding.p, finding.effect.value))
    assert kind.says(*glance) == kind.says(finding.p, finding.effect.value)
    return kind.says(finding.p, finding.effect.value)


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


@pytest.mark.parametrize(("printed", "expected"), [(5.0, 1), (5.5, 1), (7.0, 0), (3.0, 0)])
def test_a_printed_mean_is_held_against_means_of_ten(printed: float, expected: int) -> None:
    assert says(MeanIs("x1", "aco", printed), aco=sample(5)) == expected


@pytest.mark.parametrize(("printed", "expected"), [(3, 1), (5, 1), (10, 0)])
def test_a_printed_count_is_held_against_counts_of_ten(printed: int, expected: int) -> None:
    assert says(CountIs("found", "aco", printed), aco=sample(found=0.4)) == expected


@pytest.mark.parametrize(("share", "expected"), [(1.0, 1), (0.9, 0)])
def test_every_trial_means_nearly_every_one(share: float, expected: int) -> None:
    assert says(Every("found", "aco"), aco=sample(found=share)) == expected


def test_over_maps_each_counts_once() -> None:
    maps = [{"pdg": sample(5, seed=i), "pf": sample(9, seed=i + 50)} for i in range(12)]
    finding = Fewer("hitting time", "pdg", "pf").test_over(maps)
    assert finding.p == pytest.approx(stats.wilcoxon(np.ones(12)).pvalue)
    assert finding.effect.low > 0.9


@pytest.mark.parametrize(
    ("says", "verdict"),
    [
        ([1] * 10, "holds"),
        ([1] * 8 + [0] * 2, "holds"),
        ([1] * 9 + [-1], "depends on the map"),
        ([1] * 5 + [0] * 5, "depends on the map"),
        ([1] + [0] * 9, "does not hold"),
        ([0] * 3, "does not hold"),
        ([-1] * 9 + [0], "opposite"),
        ([1], "holds"),
        ([-1], "opposite"),
    ],
)
def test_a_verdict_over_maps(says: list[int], verdict: str) -> None:
    assert verdict_over(says) == verdict


def test_only_comparisons_are_corrected_and_for_their_number() -> None:
    p = corrected_p(CLAIMS, [0.01] * len(CLAIMS))
    family = sum(claim.kind.compares for claim in CLAIMS)
    assert sorted(p) == pytest.approx([0.01] * (len(CLAIMS) - family) + [0.01 * family] * family)


def test_no_two_claims_are_one() -> None:
    assert len({claim.key for claim in CLAIMS}) == len(CLAIMS)


def test_the_mean_of_ten_falls_where_the_binomial_distribution_says() -> None:
    share = mean_of_ten([np.repeat([0.0, 1.0], 500)], scale=10)
    assert (share.value, share.low, share.high) == (5.0, *stats.binom(10, 0.5).interval(0.95))


def test_over_maps_the_mean_of_ten_is_that_on_one_of_them() -> None:
    spread = mean_of_ten([np.full(50, 1.0), np.full(50, 3.0)])
    assert (spread.value, spread.low, spread.high) == (2.0, 1.0, 3.0)


def test_what_is_undefined_is_left_out() -> None:
    assert mean_of_ten([np.array([np.nan, 2.0])])[:2] == (2.0, 2.0)
    assert np.isnan(mean_of_ten([np.array([np.nan, np.nan])])).all()
