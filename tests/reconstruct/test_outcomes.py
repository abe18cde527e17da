"""Outcomes: of each trial the four numbers that the paper prints."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp.grid.moves import path_length
from acoexp.reconstruct.outcomes import Outcomes

LONG, SHORT, NONE = (4, 3), (2, 4), (-1, -1)
FOUND = np.array([LONG, SHORT, LONG, LONG])
LOST = np.array([NONE] * 4)


def test_outcomes_are_the_first_cycle_with_the_best_length_and_the_first_of_the_last_length_that_stays() -> None:
    found = Outcomes.of([FOUND])
    assert (found.x1.tolist(), found.x3.tolist()) == ([2], [3])
    assert (found.l1.tolist(), found.l2.tolist()) == ([path_length(*SHORT)], [path_length(*LONG)])


def test_a_trial_in_which_no_ant_arrived_has_cycle_0_and_no_length() -> None:
    found = Outcomes.of([LOST])
    assert (found.x1.tolist(), found.x3.tolist()) == ([0], [0])
    assert np.isnan([found.l1, found.l2]).all()


@pytest.mark.parametrize("order", [(FOUND, LOST), (LOST, FOUND)])
def test_trials_stand_in_the_order_in_which_they_were_run(order: tuple[np.ndarray, np.ndarray]) -> None:
    both = Outcomes.of(iter(order))
    first, second = (Outcomes.of([pairs]) for pairs in order)
    assert both.size == 2
    for together, joined in zip(both, first.joined(second), strict=True):
        np.testing.assert_array_equal(together, joined)
