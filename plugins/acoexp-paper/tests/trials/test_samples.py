"""What is read from each trial of a sample: the paper's columns, measures and events."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from acoexp_paper.trials.samples import EVENTS, MEASURES, first_trials, values_of

from acoexp.compare.sample import Sample

NAN = np.nan
FOUND, MISSED, STUCK = range(3)


@pytest.fixture
def sample() -> Sample:
    """Three trials on a map with the optimum 7: one stays, one never finds a path, one leaves it again."""
    curves = np.array([[9, 7, 7, 7], [NAN] * 4, [7, 9, 7, 8]], dtype=np.float64)
    features = {
        "x1": np.array([2, NAN, 1]),
        "x2": np.array([2, NAN, 3]),
        "x3": np.array([2, NAN, 4]),
        "l1": np.array([7, NAN, 7]),
        "l2": np.array([7, NAN, 8]),
        "lost_ants": np.array([1.0, 20.0, 3.0]),
    }
    steps = np.ones(curves.shape, dtype=np.int64)
    return Sample("pd", "yard", 7.0, np.array([True, False, True]), features, curves, steps)


@pytest.mark.parametrize(
    ("column", "values"),
    [
        ("x1", [2, NAN, 1]),
        ("l2", [7, NAN, 8]),
        ("x2_last", [2, NAN, 3]),
        ("n_c", [1, 0, 1]),
        ("l_bar", [7, NAN, 8]),
        ("n_bar", [2, NAN, 1]),
    ],
)
def test_a_column_of_the_papers_is_read_from_each_trial(sample: Sample, column: str, values: list[float]) -> None:
    np.testing.assert_array_equal(values_of(sample, column), values)


def test_n_bar_is_of_those_alone_that_found_the_optimum(sample: Sample) -> None:
    longer = replace(sample, optimum=6.0, found=np.full(3, False))
    assert np.isnan(values_of(longer, "n_bar")).all()


@pytest.mark.parametrize("measure", ["hitting time", "l2", "x2 - x1", "x3"])
def test_a_trial_without_a_value_ranks_behind_all_others(sample: Sample, measure: str) -> None:
    assert MEASURES[measure].values(sample).argmax() == MISSED


@pytest.mark.parametrize(
    ("event", "trials"),
    [("found", [FOUND, STUCK]), ("converged", [FOUND]), ("stuck", [MISSED, STUCK]), ("steady", [FOUND])],
)
def test_an_event_happens_in_some_trials(sample: Sample, event: str, trials: list[int]) -> None:
    assert EVENTS[event].flags(sample).nonzero()[0].tolist() == trials


def test_a_trial_is_steady_only_if_all_three_cycles_are_one(sample: Sample) -> None:
    cycles = {"x1": np.array([2.0, 2.0, 2.0]), "x2": np.array([2.0, 2.0, 3.0]), "x3": np.array([2.0, 3.0, 3.0])}
    assert EVENTS["steady"].flags(replace(sample, features=cycles)).tolist() == [True, False, False]


def test_the_first_trials_are_cut_from_everything(sample: Sample) -> None:
    first = first_trials(sample, 2)
    assert first.found.tolist() == [True, False]
    assert {values.size for values in first.features.values()} == {2}
    np.testing.assert_array_equal(first.curves, sample.curves[:2])
