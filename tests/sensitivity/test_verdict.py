"""The first sentence: it says which key matters most, and no more than is known."""

from __future__ import annotations

import numpy as np

from acoexp.sensitivity.shares import Share, Shares
from acoexp.sensitivity.verdict import leader, percent, verdict

KEYS = ["alpha", "rho"]
SEEDS = Share(0.25, 0.2, 0.3)
NOTHING = Share(-0.01, -0.1, 0.1)


def shares(alpha: Share, rho: Share, first: list[float]) -> Shares:
    return Shares([Share(0.1, 0.0, 0.2), Share(0.3, 0.2, 0.4)], [alpha, rho], NOTHING, SEEDS, np.array(first))


CLEAR = shares(NOTHING, Share(0.61, 0.52, 0.7), [0.0, 1.0])
UNSURE = shares(Share(0.5, 0.1, 0.9), Share(0.61, 0.2, 0.9), [0.4, 0.6])
NONE = shares(NOTHING, Share(0.02, -0.1, 0.1), [0.5, 0.5])


def test_a_key_that_matters_most_is_named_with_its_share_and_how_sure_one_is() -> None:
    assert verdict(KEYS, {"gap": CLEAR}, "fig13") == (
        "rho matters most on fig13: it explains 61 % [52, 70] of the variance of the gap to the optimum, "
        "30 % [20, 40] whatever the other keys are; it is the largest share in 100 % of resamples. "
        "The seed alone makes up 25 % [20, 30]."
    )


def test_one_of_which_one_is_not_sure_is_said_to_be_so() -> None:
    said = verdict(KEYS, {"gap": UNSURE}, "fig13")
    assert said.startswith("rho may matter most on fig13: ")
    assert "the largest share in only 60 % of resamples" in said


def test_where_no_key_is_shown_to_matter_none_is_said_to() -> None:
    said = verdict(KEYS, {"gap": NONE, "lost": UNSURE}, "fig13")
    assert said.startswith("No key is shown to matter on fig13: none explains more than 2 % [-10, 10] of ")
    assert "rho" not in said


def test_then_an_outcome_to_which_one_does_is_told_of() -> None:
    said = verdict(KEYS, {"gap": NONE, "cycles": NONE, "lost": CLEAR}, "fig13")
    assert " But rho explains 61 % [52, 70] of the variance of the share of ants that were lost, " in said


def test_an_outcome_that_is_always_the_same_is_passed_over() -> None:
    assert "of the cycles until the optimum was found" in verdict(KEYS, {"gap": None, "cycles": CLEAR}, "fig13")
    assert verdict(KEYS, {"gap": None}, "fig13") == "No key matters on fig13: all trials came to the same."


def test_the_leader_is_the_largest_with_what_it_does_together_with_others() -> None:
    assert [leader(one) for one in (CLEAR, UNSURE)] == [1, 1]


def test_nothing_has_no_sign() -> None:
    assert percent(Share(-0.001, -0.104, 0.001)) == "0 % [-10, 0]"
