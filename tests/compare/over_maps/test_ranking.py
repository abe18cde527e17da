"""Ranks over maps, held against a published example and another package."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp.compare.over_maps.ranking import cliques, critical_difference, friedman, nemenyi, ranks_of

DEMSAR = np.array([
    [0.763, 0.768, 0.771, 0.798],
    [0.599, 0.591, 0.590, 0.569],
    [0.954, 0.971, 0.968, 0.967],
    [0.628, 0.661, 0.654, 0.657],
    [0.882, 0.888, 0.886, 0.898],
    [0.936, 0.931, 0.916, 0.931],
    [0.661, 0.668, 0.609, 0.685],
    [0.583, 0.583, 0.563, 0.625],
    [0.775, 0.838, 0.866, 0.875],
    [1.000, 1.000, 1.000, 1.000],
    [0.940, 0.962, 0.965, 0.962],
    [0.619, 0.666, 0.614, 0.669],
    [0.972, 0.981, 0.9751, 0.975],
    [0.957, 0.978, 0.946, 0.970],
])  # fmt: skip
"""AUC of C4.5, with m, with cf, with both, on 14 data sets (Demsar 2006, Table 6); larger is better.

In the last but one he ranks two that are printed alike, 0.975, as second and third.
"""

RANKS = ranks_of(-DEMSAR)


def test_the_mean_ranks_are_the_published_ones() -> None:
    assert RANKS.mean(axis=0) == pytest.approx([3.143, 2.000, 2.893, 1.964], abs=5e-4)


def test_friedmans_test_is_the_published_one_but_for_its_ties() -> None:
    """Demsar's formula takes no account of ties; the correction divides by 1 - sum(t^3 - t) / (N k (k^2 - 1))."""
    maps, count = RANKS.shape
    tied = sum(t**3 - t for row in RANKS for t in np.unique(row, return_counts=True)[1])
    plain = friedman(RANKS).chi2 * (1.0 - tied / (maps * count * (count**2 - 1)))
    assert plain == pytest.approx(9.28, abs=5e-3)
    assert (maps - 1) * plain / (maps * (count - 1) - plain) == pytest.approx(3.69, abs=5e-3)


def test_f_is_that_of_an_analysis_of_variance_of_the_ranks() -> None:
    """Iman and Davenport's F, worked out in the other way that there is to it."""
    maps, count = RANKS.shape
    between = maps * ((RANKS.mean(axis=0) - RANKS.mean()) ** 2).sum()
    left = ((RANKS - RANKS.mean(axis=0)) ** 2).sum()
    assert friedman(RANKS).f == pytest.approx(between / (count - 1) / (left / ((count - 1) * (maps - 1))))


def test_the_critical_difference_is_the_published_one() -> None:
    assert critical_difference(4, 14) == pytest.approx(1.25, abs=5e-3)


@pytest.mark.parametrize(("count", "q"), [(2, 1.960), (3, 2.343), (4, 2.569), (5, 2.728), (7, 2.949), (10, 3.164)])
def test_critical_values_are_those_of_the_published_table(count: int, q: float) -> None:
    """Demsar 2006, Table 5 (a), as published to three digits behind the point."""
    assert critical_difference(count, 20) / np.sqrt(count * (count + 1) / 120) == pytest.approx(q, abs=1.1e-3)


def test_nemenyis_p_is_that_of_scikit_posthocs() -> None:
    posthocs = pytest.importorskip("scikit_posthocs")
    theirs = posthocs.posthoc_nemenyi_friedman(-DEMSAR).to_numpy()
    means = RANKS.mean(axis=0)
    ours = [[nemenyi(a, b, 4, 14) for b in means] for a in means]
    assert np.allclose(ours, theirs, atol=1e-6)


def test_a_difference_as_large_as_the_critical_one_has_a_p_of_5_per_cent() -> None:
    assert nemenyi(1.0, 1.0 + critical_difference(5, 30), 5, 30) == pytest.approx(0.05)


def test_values_that_are_equal_share_their_ranks_and_the_lost_share_the_last() -> None:
    assert ranks_of(np.array([[0.1, 0.0, 0.1], [np.inf, 0.0, np.inf]])).tolist() == [[2.5, 1.0, 2.5]] * 2


def test_where_all_tie_everywhere_there_is_no_test() -> None:
    assert friedman(np.full((6, 3), 2.0)) is None


def test_where_all_maps_rank_alike_f_is_infinite() -> None:
    test = friedman(np.tile([1.0, 2.0, 3.0], (6, 1)))
    assert (test.f, test.f_p) == (np.inf, 0.0)


def test_cliques_join_what_no_pair_of_which_differs_by_more() -> None:
    means, difference = RANKS.mean(axis=0), critical_difference(4, 14)
    groups = [{*group} for group in cliques(means, difference)]
    for a in range(4):
        for b in range(a):
            assert any({a, b} <= group for group in groups) == (abs(means[a] - means[b]) <= difference)


def test_a_group_within_another_is_no_group_of_its_own() -> None:
    assert cliques(np.array([1.0, 1.5, 2.0, 4.0]), 1.0) == [[0, 1, 2]]
    assert cliques(np.array([4.0, 1.0, 1.9, 2.8]), 1.0) == [[1, 2], [2, 3]]
    assert cliques(np.array([1.0, 3.0]), 1.0) == []
