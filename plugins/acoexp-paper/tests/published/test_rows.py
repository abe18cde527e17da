"""What the paper's rows say of measures and events, held against the rows."""

from __future__ import annotations

import numpy as np
from acoexp_paper.published.rows import PRINTED_EVENTS, PRINTED_MEASURES
from acoexp_paper.trials.samples import EVENTS, MEASURES


def test_they_are_some_of_the_measures_and_all_of_the_events() -> None:
    assert PRINTED_MEASURES.keys() <= MEASURES.keys()
    assert PRINTED_EVENTS.keys() == EVENTS.keys()


def test_a_trial_that_missed_the_optimum_is_behind_all() -> None:
    found, times = PRINTED_EVENTS["found"]("env2", "aco"), PRINTED_MEASURES["hitting time"]("env2", "aco")
    assert found is not None
    assert times is not None
    assert found.sum() == 5
    assert np.isinf(times[~found]).all()
    assert times[found].tolist() == [5, 2, 5, 6, 5]


def test_a_misprint_is_no_local_optimum() -> None:
    stuck = PRINTED_EVENTS["stuck"]("env2", "pd")
    assert stuck is not None
    assert stuck.sum() == 4


def test_waiting_and_steadiness_are_those_of_the_cycles() -> None:
    waiting, steady = PRINTED_MEASURES["x2 - x1"]("fig13", "aco"), PRINTED_EVENTS["steady"]("fig13", "pdg")
    assert waiting is not None
    assert steady is not None
    assert waiting[:3].tolist() == [9, 19, 0]
    assert steady.all()


def test_of_what_has_no_rows_nothing_is_said() -> None:
    assert PRINTED_MEASURES["l2"]("env1", "pdg") is None
    assert all(event("env2", "pf") is None for event in PRINTED_EVENTS.values())
