"""Rows: a configuration's trials become one row, a batch another, in an order that a person expects."""

from __future__ import annotations

import math
from typing import Any

import pytest

from acoexp.command.results.rows import rows_of


def trial(seed: int = 0, configuration: str = "c", rho: str = "0.5", **changes: Any) -> dict[str, Any]:
    """Return a trial as its record has it, with made-up figures."""
    return {
        "algo": "pdg", "map": "env2", "seed": seed, "configuration_id": configuration, "seconds": 0.002,
        "x1": 5, "x2": 6, "x3": 7, "l1": 11.0, "l2": 12.0, "optimum": 10.0, "lost_ants": [1, 0, 1],
        "config": {"algo": "pdg", "map.name": "env2", "rho": rho, "seed": str(seed)},
    } | changes  # fmt: skip


def batch(seeds: str = "0-9", configuration: str = "c", **changes: Any) -> dict[str, Any]:
    """Return a batch as its record has it."""
    names = ("x1", "x2", "x3", "l1", "l2", "lost_ants")
    return {
        "algo": "pdg", "map": "env2", "configuration_id": configuration, "optimum": 10.0, "seconds": 0.003,
        "config": {"algo": "pdg", "map.name": "env2", "rho": "0.5", "seeds": seeds},
        "trials": 10, "never_arrived": 1, "success_rate": 0.3, "expected_cycles": None,
        "means": dict.fromkeys(names, 4.0), "deviations": {**dict.fromkeys(names, 0.5), "x3": None},
    } | changes  # fmt: skip


def test_trials_of_one_configuration_are_one_row() -> None:
    (row,) = rows_of([trial(0, l1=10.0, x1=4), trial(1, l1=12.0, x1=8), trial(2, l1=10.0, seconds=0.005)])
    assert (row.algo, row.map, row.optimum) == ("pdg", "env2", 10.0)
    assert (row.summary.trials, row.found, row.milliseconds) == (3, 2, pytest.approx(3.0))
    assert (row.summary.means["x1"], row.summary.means["lost_ants"]) == (17 / 3, 2.0)
    assert row.summary.deviations["l1"] == pytest.approx(math.sqrt(4 / 3))


def test_what_a_trial_has_not_stays_out_of_the_mean() -> None:
    nothing = {"x1": 0, "x2": 0, "x3": 0, "l1": None, "l2": None}
    unknown = {"x1": None, "x2": None, "x3": None, "l1": None, "l2": None, "lost_ants": 4.0}  # as the store has it
    (row,) = rows_of([trial(0), trial(1, **nothing), trial(2, **unknown)])
    assert (row.summary.means["x1"], row.summary.means["l1"], row.summary.never_arrived) == (5.0, 11.0, 2)
    assert row.summary.means["lost_ants"] == (2 + 2 + 4) / 3
    assert row.found == 0


def test_trials_from_the_store_have_no_time_and_leave_that_of_the_others() -> None:
    (row,) = rows_of([trial(0), trial(1, seconds=None)])
    assert row.milliseconds == 2.0
    (row,) = rows_of([trial(1, seconds=None)])
    assert math.isnan(row.milliseconds)


def test_a_batch_is_a_row_of_its_own() -> None:
    rows = rows_of([trial(0), batch("0-9"), batch("0-99"), trial(1)])
    assert sorted(row.summary.trials for row in rows) == [2, 10, 10]


def test_a_batch_says_what_its_record_says_and_nan_where_that_has_none() -> None:
    (row,) = rows_of([batch()])
    assert (row.found, row.milliseconds, row.summary.never_arrived) == (3, 3.0, 1)
    assert (row.summary.means["l1"], row.summary.deviations["l1"]) == (4.0, 0.5)
    assert math.isnan(row.summary.deviations["x3"])
    assert math.isnan(row.summary.expected_cycles)
    (found,) = rows_of([batch(seconds=None)])
    assert math.isnan(found.milliseconds)


def test_rows_stand_by_map_and_algorithm_and_then_by_settings_numbers_as_numbers() -> None:
    rhos = ["10", "9", "0.5", "1e-05"]
    rows = rows_of([trial(configuration=rho, rho=rho) for rho in rhos])
    assert [row.config["rho"] for row in rows] == ["1e-05", "0.5", "9", "10"]
    places = [("env2", "pd"), ("env1", "pdg"), ("env1", "aco")]
    rows = rows_of([trial(configuration=f"{name} {algo}", map=name, algo=algo) for name, algo in places])
    assert [(row.map, row.algo) for row in rows] == sorted(places)


def test_how_far_lost_ants_came_is_known_of_what_was_run() -> None:
    (row,) = rows_of([trial(0, lost_after=None), trial(1, lost_after=3.0), trial(2, lost_after=5.0)])
    assert row.lost_after == 4.0
    (row,) = rows_of([batch(lost_after=7.0)])
    assert row.lost_after == 7.0
    assert math.isnan(rows_of([batch()])[0].lost_after)
