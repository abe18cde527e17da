"""Trials as columns: the same as results one by one, joined and kept."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from acoexp import Result, solve_many
from acoexp.trial.features import best_so_far, curve_of
from acoexp.trial.trials import Trials

SETTINGS = {"iterations": 12, "ants": 3}


@pytest.fixture(scope="module")
def results() -> list[Result]:
    """Return short trials, one of which never arrived anywhere."""
    results = solve_many("fig13", "aco", range(6), **SETTINGS)
    nothing = dataclasses.replace(results[5], curve_pairs=np.full((12, 2), -1, np.int32), moves=None)
    return [*results[:5], nothing]


def test_each_row_is_what_the_result_says(results: list[Result]) -> None:
    trials = Trials.of(results[::-1])
    assert trials.seeds.tolist() == [r.seed for r in results]
    for row, curve, result in zip(trials.table, trials.curves, results, strict=True):
        for name in ("x1", "x2", "x3", "l1", "l2", "ant_steps"):
            np.testing.assert_equal(row[name], getattr(result, name))
        assert row["lost_ants"] == result.lost_ants.sum()
        np.testing.assert_array_equal(curve, result.curve)


def test_joined_they_stand_in_the_order_of_seeds_each_once(results: list[Result]) -> None:
    joined = Trials.joined([Trials.of(results[3:]), Trials.of(results[:4])])
    assert joined.table.tobytes() == Trials.of(results).table.tobytes()
    assert joined.among(np.array([2, 4, 9], np.uint64)).seeds.tolist() == [2, 4]


def test_what_is_kept_reads_back_bit_for_bit(results: list[Result]) -> None:
    trials = Trials.of(results)
    again = Trials.from_bytes(trials.to_bytes())
    assert again.table.tobytes() == trials.table.tobytes()
    np.testing.assert_array_equal(again.lost_ants, trials.lost_ants)
    np.testing.assert_array_equal(again.cycle_steps, [result.cycle_steps for result in results])


@pytest.mark.parametrize("name", ["x1", "x2", "x3", "l1", "l2", "cycles", "lost_ants", "ant_steps", "turns"])
def test_trials_of_unequal_length_stand_side_by_side_with_the_features_of_each_alone(name: str) -> None:
    short, long = (solve_many("env2", "aco", range(4), **SETTINGS, patience=n) for n in (2, 4))
    other = [dataclasses.replace(result, seed=result.seed + 4) for result in long]
    alone = np.concatenate([Trials.of([result]).table[name] for result in (*short, *other)])
    np.testing.assert_array_equal(Trials.of([*short, *other]).table[name], alone)
    np.testing.assert_array_equal(Trials.joined([Trials.of(other), Trials.of(short)]).table[name], alone)
    assert len({result.cycles for result in short + other}) > 1


def test_the_best_so_far_is_that_of_each_curve(results: list[Result]) -> None:
    trials = Trials.of(results)
    np.testing.assert_array_equal(curve_of(trials.best_pairs), best_so_far(trials.curves))


def test_a_file_that_was_cut_off_is_told_of(results: list[Result]) -> None:
    content = Trials.of(results).to_bytes()
    for length in (0, 1, len(content) // 2, len(content) - 1):
        with pytest.raises(ValueError, match="no archive of trials"):
            Trials.from_bytes(content[:length])


def test_longer_paths_than_two_bytes_hold_are_kept(results: list[Result]) -> None:
    pairs = np.full((12, 2), 40_000, np.int32)
    long = Trials.of([dataclasses.replace(results[0], curve_pairs=pairs)])
    assert Trials.from_bytes(long.to_bytes()).curves[0, 0] == 40_000 + 40_000 * 2**0.5
