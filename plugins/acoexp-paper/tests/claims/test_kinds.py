"""What a claim is called."""

from __future__ import annotations

from acoexp_paper.claims.kinds import Claim
from acoexp_paper.claims.statements import CountIs


def test_a_claim_is_its_kinds_text_with_the_papers_remark() -> None:
    claim = Claim("Sect. 5", "env2", CountIs("found", "aco", 10), "of ten")
    assert claim.text == "Standard ACO finds the optimum in every trial (of ten)"
    assert claim.key == "env2: Standard ACO finds the optimum in every trial (of ten)"
    assert claim._replace(map="fig13").key != claim.key
