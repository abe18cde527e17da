"""The table of trials: what its rows say together, and how they are written down."""

from __future__ import annotations

import csv
import dataclasses
import math

import numpy as np
import pytest
from numpy.typing import NDArray

from acoexp import Result, solve_many
from acoexp.trial import table
from acoexp.trial.table import TABLE, aggregate, csv_lines
from acoexp.trial.trials import Trials

SETTINGS = {"iterations": 12, "ants": 3}


@pytest.fixture(scope="module")
def results() -> list[Result]:
    """Return short trials, one of which never arrived anywhere."""
    results = solve_many("fig13", "aco", range(6), **SETTINGS)
    nothing = dataclasses.replace(results[5], curve_pairs=np.full((12, 2), -1, np.int32), moves=None)
    return [*results[:5], nothing]


CYCLES = 10


def rows(*lengths: float, x1: int = 3) -> NDArray[np.void]:
    """Return trials that found such lengths; nan for one that never arrived."""
    made = np.zeros(len(lengths), TABLE)
    made["seed"], made["l1"], made["l2"] = np.arange(len(lengths)), lengths, lengths
    made["cycles"] = CYCLES
    made["x1"] = np.where(np.isnan(made["l1"]), 0, x1)
    return made


def test_aggregates_are_those_of_the_defined_values(results: list[Result]) -> None:
    optimum = min(r.l1 for r in results[:5])
    summary = aggregate(Trials.of(results).table, optimum)
    found = [r for r in results if r.l1 == optimum]
    assert (summary.trials, summary.never_arrived) == (6, 1)
    assert summary.success_rate == len(found) / 6
    spent = sum(r.x1 if r in found else 12 for r in results)
    assert summary.expected_cycles == spent / len(found)
    assert summary.means["l1"] == pytest.approx(np.mean([r.l1 for r in results[:5]]))
    assert summary.deviations["x1"] == pytest.approx(np.std([r.x1 for r in results[:5]], ddof=1))
    assert summary.means["lost_ants"] == np.mean([r.lost_ants.sum() for r in results])


def test_the_csv_reads_back_and_what_is_undefined_is_empty(results: list[Result]) -> None:
    rows = list(csv.DictReader(csv_lines(Trials.of(results).table)))
    assert [int(row["seed"]) for row in rows] == [r.seed for r in results]
    assert [float(row["l1"]) for row in rows[:5]] == [r.l1 for r in results[:5]]
    assert (rows[5]["x1"], rows[5]["x3"], rows[5]["l1"], rows[5]["l2"]) == ("", "", "", "")


def test_without_a_success_nobody_knows_how_long_one_takes() -> None:
    summary = aggregate(rows(8.0, 9.0), optimum=7.0)
    assert summary.success_rate == 0.0
    assert math.isnan(summary.expected_cycles)


def test_a_trial_that_never_arrived_spends_all_its_cycles_and_counts_in_no_mean() -> None:
    summary = aggregate(rows(7.0, math.nan, 7.0, math.nan, x1=4), optimum=7.0)
    assert (summary.trials, summary.never_arrived, summary.success_rate) == (4, 2, 0.5)
    assert summary.expected_cycles == (4 + CYCLES + 4 + CYCLES) / 2
    assert (summary.means["x1"], summary.means["l1"]) == (4.0, 7.0)


def test_what_no_trial_has_has_no_mean_and_one_trial_no_deviation() -> None:
    summary = aggregate(rows(7.0), optimum=7.0)
    assert math.isnan(summary.means["x2"])
    assert math.isnan(summary.deviations["l1"])
    assert summary.means["l1"] == 7.0


def test_a_table_of_many_slices_is_written_row_by_row(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(table, "_SLICE", 2)
    lines = list(csv_lines(rows(*range(1, 6))))
    quality = "turns,turning,clearance_mean,clearance_least,detour"
    assert lines[0] == f"seed,x1,x2,x3,l1,l2,{quality},cycles,lost_ants,ant_steps"
    expected = [f"{seed},3,,,{seed + 1}.0,{seed + 1}.0,0.0,0.0,0.0,0.0,0.0,10,0,0" for seed in range(5)]
    assert lines[1:] == expected  # of cycles alone 0 stands for none


def test_the_largest_seed_is_written_exactly() -> None:
    one = rows(7.0)
    one["seed"] = 2**64 - 1
    assert list(csv_lines(one))[1].startswith("18446744073709551615,")
