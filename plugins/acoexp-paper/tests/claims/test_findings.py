"""Everything that was found, and what a reading leads to."""

from __future__ import annotations

from dataclasses import replace

from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.findings import Findings, Outcome
from acoexp_paper.trials.experiment import Experiment
from acoexp_paper.trials.readings import DEFAULT


def test_every_claim_is_judged_in_its_order(found: Findings) -> None:
    assert [judged.claim for judged in found.claims] == list(CLAIMS)


def test_a_reading_is_judged_by_the_claims_with_published_rows(found: Findings) -> None:
    (default, nearest) = found.readings
    assert default.reading == DEFAULT
    assert default.says.keys() == nearest.says.keys() == {c.key for c in CLAIMS if c.map != "env1"}
    assert default.averages == nearest.averages == 36


def test_what_a_reading_meets_is_counted_over_all_blocks() -> None:
    outcome = Outcome(DEFAULT, {(1, "fig13", "aco"): (2, 5), (3, "env2", "pf"): (1, 3)}, {})
    assert (outcome.inside, outcome.averages) == (3, 8)


def test_without_trials_for_them_no_reading_is_judged(experiment: Experiment) -> None:
    found = Findings.of(replace(experiment, ensemble_trials=0), CLAIMS[:1])
    assert found.readings == []
    assert [judged.over_maps for judged in found.claims] == [None]
