"""The words of the verdicts."""

from __future__ import annotations

from acoexp_paper.claims.words import MEANING, VERDICTS


def test_each_verdict_is_defined_in_a_sentence_of_its_own() -> None:
    assert VERDICTS == ("shown", "compatible", "contradicted", "depends on the map", "undecided")
    assert all("." not in meaning.replace("0.05", "").replace("0.01", "") for meaning in MEANING.values())
