"""Comparisons of two algorithms, on samples whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.comparisons import Fewer, MoreOften, difference, superiority, verdict_of
from acoexp_paper.claims.pooling import Over
from made import sample, verdict

from acoexp.compare.statistics import Estimate, a12

SOONER, OFTENER = Fewer("hitting time", "pd", "aco"), MoreOften("converged", "pd", "aco")


def test_fewer_is_seen_its_opposite_too_and_no_difference_is_not() -> None:
    quick, slow, alike = sample(5, seed=1), sample(9, seed=2), sample(5, seed=3)
    assert verdict(SOONER, {"pd": quick, "aco": slow}) == "shown"
    assert verdict(SOONER, {"pd": slow, "aco": quick}) == "contradicted"
    assert verdict(SOONER, {"pd": quick, "aco": alike}) == "undecided"


def test_a_trial_that_misses_the_optimum_ranks_behind_all_that_find_it() -> None:
    quick_but_rare, slow_but_sure = sample(5, found=0.2, seed=1), sample(9, seed=2)
    assert verdict(SOONER, {"pd": quick_but_rare, "aco": slow_but_sure}) == "contradicted"


def test_more_often_is_seen_its_opposite_too_and_no_difference_is_not() -> None:
    sure, rare, alike = sample(converged=0.9, seed=1), sample(converged=0.5, seed=2), sample(converged=0.9, seed=3)
    assert verdict(OFTENER, {"pd": sure, "aco": rare}) == "shown"
    assert verdict(OFTENER, {"pd": rare, "aco": sure}) == "contradicted"
    assert verdict(OFTENER, {"pd": sure, "aco": alike}) == "undecided"


def test_maps_of_which_some_say_so_and_others_the_opposite_make_it_depend_on_the_map() -> None:
    quick, slow = sample(5, seed=1), sample(9, seed=2)
    there, back = {"pd": quick, "aco": slow}, {"pd": slow, "aco": quick}
    assert verdict(SOONER, there, there, back, there) == "depends on the map"
    assert verdict(SOONER, there, there, there, there) == "shown"


@pytest.mark.parametrize(
    ("mean", "next_map", "p", "p_between", "said"),
    [
        (0.6, (0.55, 0.65), 0.01, 0.5, "shown"),
        (0.4, (0.35, 0.45), 0.01, 0.5, "contradicted"),
        (0.6, (0.45, 0.75), 0.01, 0.5, "shown"),
        (0.6, (0.45, 0.75), 0.01, 0.001, "depends on the map"),
        (0.6, (0.55, 0.65), 0.01, 0.001, "shown"),
        (0.6, (0.45, 0.75), 0.20, 0.001, "depends on the map"),
        (0.6, (0.45, 0.75), 0.20, 0.5, "undecided"),
        (0.6, None, 0.01, 1.0, "shown"),
    ],
)
def test_the_verdict_follows_the_mean_unless_the_maps_differ_on_the_side(
    mean: float, next_map: tuple[float, float] | None, p: float, p_between: float, said: str
) -> None:
    pooled = Over(Estimate(mean, np.nan, np.nan), next_map, 0.1, 0.01, 20.0, p_between)
    assert verdict_of(pooled, 0.5, p) == said


def test_superiority_is_a12_with_the_variance_that_it_has_over_seeds() -> None:
    draw = np.random.default_rng(3)
    pairs = [(draw.integers(0, 9, 60).astype(float), draw.integers(1, 10, 60).astype(float)) for _ in range(600)]
    found = [superiority(a, b) for a, b in pairs]
    assert [effect.value for effect in found] == pytest.approx([a12(a, b) for a, b in pairs])
    assert np.mean([e.noise for e in found]) == pytest.approx(np.var([e.value for e in found]), rel=0.15)


def test_pairs_that_go_together_leave_less_noise() -> None:
    draw = np.random.default_rng(3)
    a = draw.normal(size=400)
    assert superiority(a, a + 0.2).noise < superiority(a, draw.normal(size=400) + 0.2).noise / 2


def test_a_difference_in_shares_has_the_variance_that_it_has_over_seeds() -> None:
    draw = np.random.default_rng(3)
    found = [difference(*(draw.random((2, 80)) < [[0.7], [0.4]])) for _ in range(600)]
    assert np.mean([e.value for e in found]) == pytest.approx(0.3, abs=0.01)
    assert np.mean([e.noise for e in found]) == pytest.approx(np.var([e.value for e in found]), rel=0.15)


@pytest.mark.parametrize(
    ("claim", "env", "published"),
    [
        (Fewer("hitting time", "pdg", "pd"), "fig13", 1.0),
        (MoreOften("converged", "pd", "aco"), "fig13", 0.3),
        (MoreOften("found", "pd", "aco"), "env2", 0.3),
        (MoreOften("found", "pdg", "pf"), "env2", None),
        (Fewer("lost ants", "pd", "aco"), "fig13", None),
        (Fewer("hitting time", "pdg", "pf"), "env1", None),
    ],
)
def test_the_papers_own_effect_is_that_of_its_rows(
    claim: Fewer | MoreOften, env: str, published: float | None
) -> None:
    assert claim.published(env) == (None if published is None else pytest.approx(published))


def test_a_comparison_is_of_both_algorithms_and_said_in_words() -> None:
    fewer, more = Fewer("lost ants", "pd", "aco"), MoreOften("stuck", "aco", "pdg")
    assert fewer.algos == ("pd", "aco")
    assert fewer.text == "ACO-PD loses fewer ants than standard ACO"
    assert more.text == "standard ACO converges to a local optimum more often than ACO-PDG"
