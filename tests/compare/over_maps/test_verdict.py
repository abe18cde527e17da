"""The verdict: maps are what it is drawn from, and it says so where there are too few."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from compared import maps_of

from acoexp.compare.over_maps.values import values_of_maps
from acoexp.compare.over_maps.verdict import Verdict, verdict_over

INF = float("inf")


def verdict(gaps: Sequence[Sequence[float]], trials: int = 4) -> Verdict:
    """Return the verdict on configurations a, b, c ... that end with such gaps on each map."""
    maps = maps_of(gaps, "abcdefg"[: len(gaps[0])], trials)
    return verdict_over(maps, values_of_maps(maps))


CLEAR = [[0.0, 0.1, 0.2 + 0.01 * number] for number in range(20)]


def test_what_differs_is_named_with_its_test() -> None:
    found = verdict(CLEAR)
    assert found.differ
    assert found.text == (
        "Over 20 maps the configurations differ (Friedman: chi² = 40.0, Iman and Davenport's F = ∞, p < 0.001). "
        "Mean ranks, 1 the best: a 1.00, b 2.00, c 3.00. By Nemenyi's test, critical difference 0.74: a is better "
        "than b; a and b are better than c."
    )
    assert [(row["a"], row["b"], row["verdict"]) for row in found.pairs] == [
        ("a", "b", "a better"), ("a", "c", "a better"), ("b", "c", "b better"),
    ]  # fmt: skip


def test_the_better_one_is_named_whichever_stands_first() -> None:
    found = verdict([row[::-1] for row in CLEAR])
    assert [row["verdict"] for row in found.pairs] == ["b better", "c better", "c better"]
    assert [row["cell"] for row in found.ranks] == ["c", "b", "a"]


def test_no_number_of_seeds_makes_a_verdict_of_few_maps() -> None:
    for maps in (1, 2, 4):
        found = verdict(CLEAR[:maps], trials=200)
        assert (found.pairs, found.friedman, found.difference) == ([], None, None)
        assert " no verdict over maps: it takes 5 or more" in found.text
        assert np.isnan(found.ranks[0]["low"])


def test_more_seeds_of_the_same_change_nothing() -> None:
    noisy = np.random.default_rng(1).random((9, 3)).tolist()
    few, many = verdict(noisy, trials=2), verdict(noisy, trials=300)
    assert (few.text, few.pairs, few.ranks) == (many.text, many.pairs, many.ranks)


def test_where_friedmans_test_shows_nothing_no_pair_is_told_apart() -> None:
    found = verdict(np.random.default_rng(1).random((9, 4)).tolist())
    assert not found.differ
    assert found.text.startswith("Over 9 maps no difference is shown (Friedman: chi² = ")
    assert {row["verdict"] for row in found.pairs} == {"no difference shown"}


def test_lost_maps_rank_last_and_are_counted() -> None:
    found = verdict([[0.3, INF, INF]] * 6)
    assert found.mean_ranks.tolist() == [1.0, 2.5, 2.5]
    assert [(row["cell"], row["best_on"], row["lost_on"]) for row in found.ranks] == [
        ("a", 6, 0), ("b", 0, 6), ("c", 0, 6),
    ]  # fmt: skip


@pytest.mark.parametrize("gap", [0.0, INF])
@pytest.mark.parametrize("count", [2, 3])
def test_where_all_are_equal_or_all_are_lost_it_says_that_there_is_nothing_to_rank(gap: float, count: int) -> None:
    found = verdict([[gap] * count] * 8)
    assert found.text.startswith("No difference: on each of 8 maps all configurations have the same median gap")
    assert found.friedman is None
    assert {(row["p"], row["verdict"]) for row in found.pairs} == {(1.0, "no difference shown")}
    assert {row["best_on"] for row in found.ranks} == {8 if gap == 0.0 else 0}


def test_two_configurations_have_the_sign_test_over_maps() -> None:
    found = verdict([[0.1, 0.2]] * 9 + [[0.0, 0.0]] * 3)
    (row,) = found.pairs
    assert (row["test"], row["p"]) == ("sign test", pytest.approx(2 / 2**9))
    assert (row["wins"], row["ties"], row["losses"]) == (9, 3, 0)
    assert found.text == (
        "Over 12 maps: a is better (sign test over maps, p = 0.004): a wins on 9, b on 0, and 3 tie. "
        "Mean ranks: a 1.12, b 1.88."
    )
    assert verdict([[0.1, 0.2], [0.2, 0.1]] * 4).text.startswith("Over 8 maps: no difference is shown (sign test")


def test_effects_have_intervals_over_maps() -> None:
    (row,) = verdict([[0.1, 0.2]] * 7 + [[0.2, 0.1]] * 2).pairs
    assert row["a12"] == pytest.approx(7 / 9)
    assert row["next_low"] <= row["low"] < row["a12"] < row["high"] <= row["next_high"]


def test_intervals_of_mean_ranks_are_a_bootstrap_over_maps() -> None:
    row = verdict([[0.1, 0.2, 0.3]] * 10 + [[0.3, 0.1, 0.2]] * 10).ranks[0]
    assert row["low"] < row["mean_rank"] < row["high"]
