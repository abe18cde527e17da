"""x1, x2, x3, l1, l2: what they are, and that the paper's own rows fit what we take them for."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from acoexp.grid import path_length
from acoexp.trial.features import Features, best_so_far, features_of, prolonged, x2_last

OPTIMUM_1, LONGER_1 = path_length(12, 13), path_length(14, 14)
"""30.3848 and 33.7990, the two lengths of Table 1."""
OPTIMUM_2, NEXT_2 = path_length(28, 5), path_length(30, 4)
"""35.0711 and 35.6569, the best lengths of Table 2; then those that trials converge to."""
A, B, C = path_length(34, 2), path_length(32, 4), path_length(36, 2)
ELSEWHERE = path_length(50, 20)
CYCLES = 200

TABLE_1 = [
    (10, OPTIMUM_1, 19, LONGER_1, 29),  # standard ACO, trial 1
    (14, OPTIMUM_1, 33, LONGER_1, 35),
    (7, OPTIMUM_1, 7, OPTIMUM_1, 7),
    (15, OPTIMUM_1, 15, LONGER_1, 22),
    (10, OPTIMUM_1, 60, LONGER_1, 61),  # never twice in a row: the last that found it
    (6, OPTIMUM_1, 9, OPTIMUM_1, 9),  # ACO-PD, trial 5
    (2, OPTIMUM_1, 2, OPTIMUM_1, 2),  # ACO-PDG, trial 1
]
TABLE_2 = [
    (5, OPTIMUM_2, 32, A, 34),  # standard ACO, trial 1
    (4, NEXT_2, 12, B, 25),
    (6, NEXT_2, 13, A, 14),  # never twice in a row
    (2, OPTIMUM_2, 6, C, 8),
    (5, OPTIMUM_2, 15, OPTIMUM_2, 18),
    (5, OPTIMUM_2, 15, OPTIMUM_2, 15),
    (3, OPTIMUM_2, 16, path_length(38, 18), 33),  # ACO-PD, trial 4: l2 is no shortest path of anything
    (1, OPTIMUM_2, 1, OPTIMUM_2, 1),  # ACO-PDG, trial 2
]


def curve_of(x1: int, l1: float, x2: int, l2: float, x3: int) -> list[float]:
    """Draw a curve of which a row of the tables may speak."""
    curve = [ELSEWHERE] * CYCLES
    curve[x1 - 1] = curve[x2 - 1] = l1
    if x2 + 1 < x3:  # found twice in a row, and then lost again
        curve[x2] = l1
    curve[x3 - 1 :] = [l2] * (CYCLES - x3 + 1)
    return curve


@pytest.mark.parametrize("row", TABLE_1 + TABLE_2)
def test_the_published_rows_fit_the_definitions(row: tuple[int, float, int, float, int]) -> None:
    x1, l1, x2, l2, x3 = row
    assert features_of(np.array(curve_of(*row))) == Features(x1, x2, x3, l1, l2)


@pytest.mark.parametrize("row", TABLE_1 + TABLE_2)
def test_the_published_rows_fit_the_other_reading_of_x2_too(row: tuple[int, float, int, float, int]) -> None:
    x1, l1, x2, l2, x3 = row
    curve = np.array(curve_of(*row))
    if l1 != l2:
        curve[x2 : x3 - 1] = ELSEWHERE  # lost after x2
        curve[x1 - 1 : x2 : 2] = l1  # and found before, now and then
        curve[x2 - 1] = l1
    assert x2_last(curve) == x2
    assert features_of(curve)._replace(x2=x2) == Features(x1, x2, x3, l1, l2)


def features(*curve: float) -> tuple[int, int, int, float, float]:
    return tuple(features_of(np.array(curve)))  # type: ignore[return-value]


def test_the_best_so_far_falls_and_is_there_from_the_first_length_on() -> None:
    found = best_so_far(np.array([np.nan, 5.0, np.nan, 4.0, 6.0]))
    np.testing.assert_array_equal(found, [np.nan, 5.0, 5.0, 4.0, 4.0])


@given(st.lists(st.sampled_from([(-1, -1), (3, 0), (4, 0), (5, 0)]), min_size=1, max_size=6), st.integers(0, 3))
def test_a_trial_that_stays_as_in_its_last_cycle_keeps_all_of_its_features(
    pairs: list[tuple[int, int]], more: int
) -> None:
    longer = prolonged(np.array(pairs), len(pairs) + more)
    curves = [[np.nan if straight < 0 else float(straight) for straight, _ in cut] for cut in (pairs, longer)]
    assert len(longer) == len(pairs) + more
    np.testing.assert_equal(*(features_of(np.array(curve)) for curve in curves))


def test_x1_is_the_first_cycle_that_found_the_best_length() -> None:
    assert features(9, 7, 5, 6, 5, 5, 6)[0] == 3


def test_x2_is_the_first_of_two_successive_cycles_that_found_it() -> None:
    assert features(9, 5, 6, 5, 5, 6, 5, 5)[1] == 4


def test_x2_is_the_last_cycle_that_found_it_where_no_two_in_a_row_did() -> None:
    assert features(9, 5, 6, 5, 6, 6)[1] == 4
    assert features(9, 5, 6, 6)[1] == 2
    assert features(9, 5, np.nan, 5, 6)[1] == 4


def test_x2_may_be_the_last_cycle_of_all() -> None:
    assert features(9, 8, 5) == (3, 3, 3, 5, 5)
    assert features(5, 8, 5) == (1, 3, 3, 5, 5)


def test_in_its_other_reading_x2_is_the_last_cycle_that_found_it_unless_the_run_converges_to_it() -> None:
    assert x2_last(np.array([9, 5, 5, 6, 5, 6, 6])) == 5
    assert x2_last(np.array([9, 5, 5, 6, 5, np.nan])) == 5
    assert x2_last(np.array([9, 5, 6, 5, 5])) == 4
    assert x2_last(np.array([np.nan, np.nan])) == 0


def test_x3_is_the_first_cycle_from_which_the_curve_stays_where_it_ends() -> None:
    assert features(9, 5, 7, 7, 6, 7, 7, 7)[2] == 6
    assert features(9, 5, 6, 7)[2] == 4


def test_l2_need_not_be_the_best_length() -> None:
    assert features(9, 5, 5, 7, 7)[3:] == (5, 7)


def test_a_cycle_whose_ants_were_all_lost_is_passed_over() -> None:
    assert features(np.nan, 9, 5, np.nan, 5, 5) == (3, 5, 5, 5, 5)


def test_a_trial_that_never_arrived_has_no_features() -> None:
    x1, x2, x3, l1, l2 = features(np.nan, np.nan)
    assert (x1, x2, x3) == (0, 0, 0)
    assert np.isnan([l1, l2]).all()


def test_a_trial_that_lost_its_last_cycle_converged_to_nothing() -> None:
    x1, x2, x3, l1, l2 = features(9, 5, 5, np.nan)
    assert (x1, x2, x3, l1) == (2, 2, 0, 5)
    assert np.isnan(l2)


def test_one_cycle_is_a_curve() -> None:
    assert features(7) == (1, 1, 1, 7, 7)


def test_cycles_are_plain_numbers() -> None:
    assert [type(value) for value in features(9, 5, 5)] == [int, int, int, float, float]


LENGTHS = st.lists(st.sampled_from([5.0, 6.0, 7.0, np.nan]), min_size=1, max_size=12)


@given(LENGTHS)
def test_the_definitions_hold_for_any_curve(curve: list[float]) -> None:
    x1, x2, x3, l1, l2 = features(*curve)
    best = [t for t, length in enumerate(curve, 1) if length == l1]
    twice = [t for t in best if t + 1 in best]
    if not best:
        assert (x1, x2, x3) == (0, 0, 0)
        return
    assert l1 == min(length for length in curve if length == length)
    assert (x1, x2) == (best[0], (twice or best[-1:])[0])
    if l2 == l2:
        assert l2 == curve[-1]
        assert x3 == next(t for t in range(1, len(curve) + 1) if set(curve[t - 1 :]) == {l2})
        assert 1 <= x1 <= x2
        assert x2 <= x3
    else:
        assert x3 == 0
