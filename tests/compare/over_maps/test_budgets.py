"""What a budget buys, counted trial by trial and target by target."""

from __future__ import annotations

import numpy as np
import pytest
from compared import LOST, sample

from acoexp.compare.over_maps.budgets import TARGETS, anytime, reached
from acoexp.compare.sample import Sample

RANDOM = np.random.default_rng(4)


def drawn(configuration: str, name: str, cycles: int = 9, trials: int = 6) -> Sample:
    """Return trials that find paths by chance, or none."""
    lengths = 10.0 + RANDOM.integers(0, 12, (trials, cycles)) * 0.5
    lengths[RANDOM.random(lengths.shape) < 0.3] = LOST
    return sample(lengths.tolist(), configuration, name, steps=RANDOM.integers(10, 500, lengths.shape).tolist())


MAPS = [[drawn("a", name), drawn("b", name, cycles=5)] for name in ("one", "two", "three", "four", "five")]


def best_within(one: Sample, trial: int, unit: str, budget: float) -> float:
    """Return the gap that a trial has within a budget, cycle by cycle."""
    best = np.inf
    for cycle in range(one.iterations):
        spent = cycle + 1 if unit == "cycles" else one.steps[trial, cycle] / one.optimum
        if spent <= budget and (one.curves[trial, cycle] - one.optimum) / one.optimum < best:
            best = (one.curves[trial, cycle] - one.optimum) / one.optimum
    return best


@pytest.mark.parametrize("unit", ["cycles", "ant steps"])
def test_both_views_are_counted_over_trials_targets_and_maps(unit: str) -> None:
    for place, found in enumerate(anytime(MAPS, unit, inference=True)):
        assert found.configuration == "ab"[place]
        for at in (0, len(found.budgets) // 2, -1):
            budget = found.budgets[at]
            gaps = [[best_within(of_map[place], t, unit, budget) for t in range(6)] for of_map in MAPS]
            shares = [np.mean([[gap <= target for target in TARGETS] for gap in of_map]) for of_map in gaps]
            medians = sorted(sorted(of_map)[2] for of_map in gaps)
            assert found.hit[at] == pytest.approx(np.mean(shares))
            assert (found.gap_low[at], found.gap[at], found.gap_high[at]) == (medians[1], medians[2], medians[3])


@pytest.mark.parametrize("unit", ["cycles", "ant steps"])
def test_budgets_reach_from_the_first_cycle_to_the_end_of_the_longest_trial(unit: str) -> None:
    a, b = anytime(MAPS, unit, inference=False)
    assert np.array_equal(a.budgets, b.budgets)
    for place, one in enumerate((a, b)):
        ends = [of_map[place].gaps[:, -1].tolist() for of_map in MAPS]
        assert [reached(of_map[place], unit, one.budgets[-1:])[:, 0].tolist() for of_map in MAPS] == ends


def test_more_budget_is_never_worse() -> None:
    for one in anytime(MAPS, "ant steps", inference=False):
        assert (np.diff(one.hit) >= 0.0).all()
        assert all(later <= sooner for sooner, later in zip(one.gap, one.gap[1:], strict=False))


def test_intervals_are_over_maps_and_there_are_none_without_enough_of_them() -> None:
    (with_interval, _), (without, _) = (anytime(MAPS, "cycles", inference=yes) for yes in (True, False))
    assert (with_interval.hit_low <= with_interval.hit).all()
    assert (with_interval.hit <= with_interval.hit_high).all()
    assert np.isnan(without.hit_low).all()
    more_seeds = [
        [sample(np.repeat(o.curves, 9, axis=0).tolist(), o.configuration, o.map) for o in m] for m in MAPS
    ]
    assert anytime(more_seeds, "cycles", inference=True)[0].hit_low == pytest.approx(with_interval.hit_low)


def test_rows_have_all_that_the_pictures_show() -> None:
    one = anytime(MAPS, "cycles", inference=True)[0]
    row = one.rows()[0]
    assert list(row) == ["cell", "unit", "budgets", "hit", "hit_low", "hit_high", "gap", "gap_low", "gap_high"]
    assert (row["cell"], row["unit"], row["budgets"], row["hit"]) == ("a", "cycles", 1.0, one.hit[0])
