"""Rows: numbers of which a person can tell where they come from."""

from __future__ import annotations

import numpy as np
import pytest
import scipy

from acoexp.sensitivity.design import Level
from acoexp.sensitivity.outcomes import Measured
from acoexp.sensitivity.rows import SEEDS, TOGETHER, curve_rows, point_rows, share_rows
from acoexp.sensitivity.shares import Share, Shares


def measured(gaps: list[float], found: list[bool]) -> Measured:
    """Return trials with these gaps; each that found the optimum took four cycles, others all nine."""
    flags = np.array(found)
    cycles = np.where(flags, 4.0, 9.0)
    return Measured(
        {"gap": np.array(gaps), "cycles": cycles, "found": 100.0 * flags, "lost": np.full(len(gaps), 2.5)}, flags
    )


def test_shares_stand_by_outcome_and_key_then_what_else_explains_it() -> None:
    one = Shares(
        [Share(0.3, 0.2, 0.4)], [Share(0.5, 0.4, 0.6)], Share(0.2, 0.1, 0.3), Share(0.5, 0.4, 0.6), np.ones(1)
    )
    rows = share_rows(["rho"], {"gap": one, "lost": None})
    assert [(row["outcome"], row["source"]) for row in rows] == [
        ("gap", "rho"), ("gap", TOGETHER), ("gap", SEEDS), ("lost", "rho"), ("lost", TOGETHER), ("lost", SEEDS),
    ]  # fmt: skip
    assert (rows[0]["alone"], rows[0]["total_low"], rows[0]["first"]) == (0.3, 0.4, 1.0)
    assert (rows[1]["alone"], rows[2]["alone_high"]) == (0.2, 0.6)
    assert np.isnan([rows[1]["total"], rows[2]["first"], rows[3]["alone"], rows[5]["alone"]]).all()


def test_curves_have_means_intervals_and_expected_cycles() -> None:
    gaps = [0.0, 0.0, 1.0, 2.0, 7.0]
    (row,) = curve_rows([Level("rho", 0.5)], [measured(gaps, [True, True, False, False, False])], worst=9.0)
    assert (row["key"], row["value"], row["trials"], row["never_arrived"]) == ("rho", 0.5, 5, 0)
    assert (row["gap"], row["cycles"], row["found"], row["lost"]) == (2.0, 7.0, 40.0, 2.5)
    assert row["expected_cycles"] == 35.0 / 2.0
    wilson = scipy.stats.binomtest(2, 5).proportion_ci(method="wilson")
    assert (row["found_low"], row["found_high"]) == pytest.approx((100.0 * wilson.low, 100.0 * wilson.high))
    drawn = scipy.stats.bootstrap((gaps,), np.mean, method="percentile", n_resamples=9999).confidence_interval
    assert (row["gap_low"], row["gap_high"]) == pytest.approx((drawn.low, drawn.high), abs=0.6)
    assert (row["lost_low"], row["lost_high"]) == (2.5, 2.5)


def test_trials_in_which_no_ant_arrived_are_the_worst_on_a_curve() -> None:
    (row,) = curve_rows([Level("rho", 0.5)], [measured([1.0, np.nan], [False, False])], worst=9.0)
    assert (row["never_arrived"], row["gap"], row["expected_cycles"]) == (1, 5.0, np.inf)


def test_points_stand_sample_by_sample_with_what_they_came_to() -> None:
    points = [{"rho": value} for value in (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)]
    given = [measured([float(place), np.nan], [False, False]) for place in range(6)]
    rows = point_rows(points, given, size=2)
    assert [row["sample"] for row in rows] == ["A", "A", "B", "B", "A with rho of B", "A with rho of B"]
    assert [(row["rho"], row["gap"]) for row in rows[:2]] == [(0.1, 0.0), (0.2, 1.0)]
    assert {row["never_arrived"] for row in rows} == {1}
    none = point_rows(points[:1], [measured([np.nan, np.nan], [False, False])], size=1)
    assert np.isnan(none[0]["gap"])
