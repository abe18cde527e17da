"""Everything that was found."""

from __future__ import annotations

from dataclasses import replace

from acoexp_paper.claims.catalogue import CLAIMS
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.likelihood import scores
from acoexp_paper.trials.experiment import Experiment
from small import MAPS


def test_every_claim_is_judged_in_its_order_on_all_maps(found: Findings) -> None:
    assert [judged.claim for judged in found.claims] == list(CLAIMS)
    assert {len(judged.effects) for judged in found.claims} == {1 + MAPS}


def test_what_the_maps_were_fitted_to_is_not_counted(found: Findings) -> None:
    assert [judged.claim for judged in found.counted] == [claim for claim in CLAIMS if not claim.fitted]


def test_each_map_comes_with_its_score_and_weighs_by_it(found: Findings, experiment: Experiment) -> None:
    assert found.scores["fig13"].tolist() == scores(experiment.maps_of("fig13")).tolist()
    assert all(judged.weighted is not None for judged in found.claims)


def test_a_reading_is_judged_by_the_claims_with_published_rows_but_for_those_of_aco_pf(found: Findings) -> None:
    (nearest,) = found.readings
    assert nearest.claims.keys() == {c.key for c in CLAIMS if c.map != "env1" and "pf" not in c.kind.algos}
    assert nearest.fit.keys() == found.met.keys()
    assert nearest.averages == sum(of for _, of in found.met.values()) == 33


def test_without_trials_for_them_no_reading_is_judged(experiment: Experiment) -> None:
    found = Findings.of(replace(experiment, reading_trials=0), CLAIMS[:1])
    assert found.readings == []
