"""What a claim is called, and a mean over maps."""

from __future__ import annotations

import numpy as np
from acoexp_paper.claims.kinds import Claim, mean_over
from acoexp_paper.claims.statements import Every


def test_a_claim_is_its_kinds_text_with_the_papers_remark() -> None:
    claim = Claim("Sect. 5", "env2", Every("found", "aco"), "of ten")
    assert claim.text == "Standard ACO finds the optimum in every trial (of ten)"
    assert claim.key == "env2: Standard ACO finds the optimum in every trial (of ten)"
    assert claim._replace(map="fig13").key != claim.key


def test_a_mean_over_maps_has_an_interval_that_narrows_with_their_number() -> None:
    effects = np.linspace(0.4, 0.6, 9)
    few, many = mean_over(effects), mean_over(np.tile(effects, 16))
    assert few.value == many.value == 0.5
    assert 0.4 < few.low < many.low < 0.5 < many.high < few.high < 0.6


def test_maps_that_agree_leave_no_interval() -> None:
    assert mean_over(np.array([0.7])) == mean_over(np.full(4, 0.7)) == (0.7, 0.7, 0.7)
