"""Rows of configurations and pairs, on trials made up for it."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp import Grid
from acoexp.compare.measures import configuration_row, measured, pair_rows
from acoexp.compare.sample import Sample
from acoexp.trial.features import NAMES
from acoexp.trial.trials import Trials

K = 20


def sample(label: str, x1: list[int], found: list[bool], l2: list[float], name: str = "yard") -> Sample:
    """Return a configuration's trials."""
    n = len(x1)
    first = np.array([cycle or np.nan for cycle in x1])
    features = {"x1": first, "x2": first, "x3": first, "l1": np.full(n, 7.0), "l2": np.array(l2)}
    features["lost_ants"] = np.arange(n, dtype=np.float64)
    features = {**dict.fromkeys(NAMES, np.full(n, np.nan)), **features, "cycles": np.full(n, float(K))}
    steps = np.ones((n, K), dtype=np.int64)
    return Sample(label, name, 7.0, np.array(found), features, np.full((n, K), 7.0), steps)


QUICK = sample("quick", [1, 2] * 10, [True] * 20, [7.0] * 20)
SLOW = sample("slow", [9, 8] * 10, [True] * 20, [9.0] * 20)
LOST = sample("lost", [1, 0] * 10, [False] * 20, [np.nan] * 20)


def verdicts(*samples: Sample) -> dict[tuple[str, str, str], str]:
    """Return each pair's verdicts by configurations and measure."""
    return {(row["a"], row["b"], row["measure"]): row["verdict"] for row in pair_rows(samples)}


def test_a_configurations_row() -> None:
    row = configuration_row(sample("c", [4, 6, 3, 0], [True, True, False, False], [7.0, 8.0, 9.0, np.nan]))
    assert row["x1"] == pytest.approx(13 / 3)
    assert row["l2"] == 8.0
    assert row["l2_sd"] == 1.0
    assert row["lost_ants"] == 1.5
    assert (row["found"], row["trials"], row["success"]) == (2, 4, 0.5)
    assert row["ert"] == (4 + 6 + K + K) / 2  # what missed the optimum spent all its cycles


def test_verdicts_name_the_better_configuration_whichever_stands_first() -> None:
    said = verdicts(QUICK, SLOW, LOST) | verdicts(SLOW, QUICK)
    assert said["quick", "slow", "l2"] == said["slow", "quick", "l2"] == "quick better"
    assert said["quick", "slow", "hitting time"] == said["slow", "quick", "hitting time"] == "quick better"
    assert said["quick", "slow", "success"] == "no difference shown"


def test_trials_that_miss_the_optimum_rank_behind_however_early_their_x1() -> None:
    said = verdicts(SLOW, LOST)
    assert said["slow", "lost", "hitting time"] == "slow better"
    assert said["slow", "lost", "success"] == "slow better"


def test_a_run_whose_last_ants_were_lost_ranks_behind_every_length() -> None:
    assert verdicts(SLOW, LOST)["slow", "lost", "l2"] == "slow better"


def test_a_configuration_does_not_differ_from_itself() -> None:
    rows = pair_rows([LOST, LOST])
    assert {row["verdict"] for row in rows} == {"no difference shown"}
    assert [row["p_holm"] for row in rows] == [1.0, 1.0, 1.0]


def test_only_configurations_on_one_map_are_compared_and_all_tests_are_one_family() -> None:
    elsewhere = [sample(label, [1, 2] * 10, [True] * 20, [7.0] * 20, "field") for label in ("quick", "slow")]
    alone, both = pair_rows([QUICK, SLOW]), pair_rows([QUICK, SLOW, *elsewhere])
    assert [(row["map"], row["measure"]) for row in both] == [
        (name, measure) for name in ("yard", "field") for measure in ("l2", "hitting time", "success")
    ]
    assert both[0]["p"] == alone[0]["p"]
    assert both[0]["p_holm"] == pytest.approx(2 * alone[0]["p_holm"])


def test_what_is_measured_of_trials_is_nan_where_it_is_undefined() -> None:
    grid = Grid([[0, 0, 0], [0, 0, 0], [0, 0, 0]], name="yard")
    pairs = np.array([[[0, 2], [0, 2]], [[4, 0], [-1, -1]], [[-1, -1], [-1, -1]]], dtype=np.int32)
    lost = np.array([[0, 0], [0, 1], [1, 1]], dtype=np.int32)
    trials = Trials(
        np.arange(3, dtype=np.uint64),
        pairs,
        lost,
        np.ones((3, 2), dtype=np.int64),
        np.full(3, 2, np.int32),
        np.zeros((3, 5)),
    )
    found = measured("mine", grid, trials)
    assert (found.configuration, found.map, found.optimum) == ("mine", "yard", grid.optimum)
    assert found.found.tolist() == [True, False, False]
    assert found.iterations == 2
    assert np.array_equal(found.features["x1"], [1.0, 1.0, np.nan], equal_nan=True)
    assert np.array_equal(found.features["l2"], [grid.optimum, np.nan, np.nan], equal_nan=True)
    assert found.features["lost_ants"].tolist() == [0.0, 1.0, 2.0]
