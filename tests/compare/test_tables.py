"""The tables that a person reads: each number with as many digits as matter, and with its spread or interval."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from acoexp.compare.measures import configuration_row, pair_rows
from acoexp.compare.sample import Sample
from acoexp.compare.tables import tables_of
from acoexp.report.table import Table
from acoexp.trial.features import NAMES


def sample(configuration: str, found: list[bool], l2: list[float]) -> Sample:
    """Return trials on a map whose optimum is 7; x1 is 4 in all of them, x2 and x3 in none."""
    n = len(found)
    features = {
        **dict.fromkeys(NAMES, np.full(n, np.nan)),
        **{"turns": np.arange(n) % 2, "turning": np.full(n, np.pi / 4), "cycles": np.full(n, 20.0)},
        **{"x1": np.full(n, 4.0), "x2": np.full(n, np.nan), "x3": np.full(n, np.nan)},
        **{"l1": np.full(n, 7.0), "l2": np.array(l2), "lost_ants": np.arange(n, dtype=np.float64)},
    }
    steps = np.ones((n, 20), dtype=np.int64)
    return Sample(configuration, "yard", 7.0, np.array(found), features, np.full((n, 20), 7.0), steps)


@pytest.fixture(scope="module")
def tables() -> dict[str, Table]:
    """Return the tables of two configurations, by their titles."""
    samples = [sample("quick", [True] * 20, [7.0] * 20), sample("slow", [False] * 20, [9.0] * 20)]
    return {table.title: table for table in tables_of([*map(configuration_row, samples)], pair_rows(samples))}


def row(table: Table, number: int = 0) -> dict[str, Any]:
    """Return one row by its headings."""
    return dict(zip(table.headings, table.rows[number], strict=True))


def test_features_stand_with_their_deviation_and_a_dash_where_no_trial_has_one(tables: dict[str, Table]) -> None:
    quick = row(tables["Features"])
    assert (quick["map"], quick["cell"], quick["optimum"]) == ("yard", "quick", "7.0000")
    assert (quick["x1"], quick["x2"]) == ("4.0 ± 0.0", "-")
    assert quick["l1"] == "7.0000 ± 0.00"
    assert (quick["l2"], quick["lost ants"]) == ("7.0000 ± 0.00", "9.5 ± 5.9")


def test_the_quality_of_paths_has_a_dash_where_it_is_not_known(tables: dict[str, Table]) -> None:
    quick = row(tables["Quality of paths"])
    assert (quick["turns"], quick["turning"], quick["detour"]) == ("0.5 ± 0.5", "0.79 ± 0.00", "-")


def test_success_is_counted_with_its_rate_and_the_time_that_it_takes(tables: dict[str, Table]) -> None:
    quick, slow = row(tables["Success"], 0), row(tables["Success"], 1)
    assert (quick["found"], slow["found"]) == ("20/20", "0/20")
    assert quick["success rate"].startswith("1.00 [0.8")
    assert (quick["expected running time (cycles)"], slow["expected running time (cycles)"]) == (
        "4.00 [4.00, 4.00]",
        "∞",
    )


def test_each_pair_has_an_effect_a_test_and_a_verdict_for_each_measure(tables: dict[str, Table]) -> None:
    said = {one["measure"]: one for one in (row(tables["Pairs"], place) for place in range(3))}
    assert said.keys() == {"l2", "hitting time", "success"}
    assert {(one["a"], one["b"], one["verdict"]) for one in said.values()} == {("quick", "slow", "quick better")}
    assert (said["l2"]["effect"], said["l2"]["size"]) == ("A12", "1.00 [1.00, 1.00]")
    assert {one["p"] for one in said.values()} == {"< 0.001"}
