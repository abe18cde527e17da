"""What becomes of claims under another reading, on samples whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.claims.comparisons import Fewer
from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.rereading import Outcome, outcome, with_changes
from acoexp_paper.claims.statements import CountIs
from acoexp_paper.trials.readings import SUM_IN
from acoexp_paper.trials.samples import Samples
from made import sample

SOONER = Claim("", "env2", Fewer("hitting time", "pd", "aco"))
ELSEWHERE = Claim("", "env1", CountIs("found", "pf", 10))


def maps(pd: int, aco: int) -> list[Samples]:
    return [{"pd": sample(pd, seed=i), "aco": sample(aco, seed=i + 50)} for i in range(5)]


def reread(new: list[Samples | None], old: list[Samples]) -> Outcome:
    return outcome(SUM_IN, [SOONER, ELSEWHERE], {"env2": new}, {"env2": old})


def test_a_claim_is_judged_again_and_its_effect_compared_on_the_same_maps() -> None:
    found = reread([*maps(5, 9)], maps(7, 7))
    again = found.claims[SOONER.key]
    assert again.judged.verdict == "shown"
    assert again.change.low < 0.5 < again.change.value + 0.1
    assert again.p < 0.001


def test_claims_about_other_environments_are_left_out() -> None:
    assert reread([*maps(5, 9)], maps(7, 7)).claims.keys() == {SOONER.key}


def test_a_map_that_a_reading_does_not_fit_does_not_count() -> None:
    new: list[Samples | None] = [*maps(5, 9)]
    found = reread([None, *new[1:]], maps(5, 9))
    assert found.maps == {"env2": 4}
    assert (found.claims[SOONER.key].p, np.isnan(found.claims[SOONER.key].change.value)) == (1.0, True)
    assert reread([None] * 5, maps(5, 9)).claims == {}


@pytest.mark.parametrize(
    ("pd", "verdict", "changed"),
    [(5, "undecided", True), (5, "shown", False), (7, "shown", False)],
)
def test_a_reading_changes_a_claim_if_effect_and_verdict_are_others(pd: int, verdict: str, changed: bool) -> None:
    (found,) = with_changes([reread([*maps(pd, 9)], maps(7, 9))], {SOONER.key: verdict})
    assert found.changed == ((SOONER.key,) if changed else ())
