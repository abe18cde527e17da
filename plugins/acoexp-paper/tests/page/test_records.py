"""``tables.json`` in full precision."""

from __future__ import annotations

from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.records import count_verdicts, records
from small import ENSEMBLE_TRIALS, MAPS, TRIALS


def test_an_average_is_there_as_it_was_found(found: Findings) -> None:
    number, row = next((n, row) for n, row in enumerate(found.averages) if row.inside != row.ensemble_inside)
    record = records(found)["tables"][number]
    assert (record["table"], record["map"], record["algorithm"], record["column"]) == row.printed[:4]
    assert (record["published"], record["first_ten"]) == (row.printed.value, row.first_ten)
    assert (record["mean"], *record["interval"]) == row.ours
    assert (record["ensemble_mean"], *record["ensemble_interval"]) == row.ensemble
    assert (record["inside"], record["ensemble_inside"]) == (row.inside, row.ensemble_inside)


def test_a_claim_is_there_with_both_of_its_tests(found: Findings) -> None:
    judged, record = found.claims[0], records(found)["claims"][0]
    assert (record["key"], record["verdict"]) == (judged.claim.key, judged.verdict)
    assert (record["statistic"], record["p"], record["measure"]) == judged.finding[:3]
    assert (record["effect"], *record["interval"]) == judged.finding.effect
    assert record["p_holm"] == judged.p_holm
    assert record["over_maps"]["statistic"] == judged.over_maps.statistic
    assert record["maps"] == list(judged.says)


def test_what_was_left_out_is_null(found: Findings) -> None:
    alone = found._replace(
        averages=[found.averages[0]._replace(ensemble=None)],
        claims=[found.claims[0]._replace(over_maps=None, says=())],
        readings=[],
    )
    record = records(alone)
    (average,), (claim,) = record["tables"], record["claims"]
    assert (average["ensemble_mean"], average["ensemble_interval"], average["ensemble_inside"]) == (None,) * 3
    assert (claim["over_maps"], claim["maps"], record["readings"]) == (None, [], [])


def test_the_trials_and_maps_behind_it_are_named(found: Findings) -> None:
    record = records(found)
    assert (record["trials"], record["ensemble_trials"]) == (TRIALS, ENSEMBLE_TRIALS)
    assert record["maps"]["env2"]["digest"] == found.experiment.maps["env2"].digest
    assert len(set(record["maps"]["env2"]["ensemble"])) == MAPS


def test_a_reading_is_there_with_its_fit_by_block(found: Findings) -> None:
    outcome, record = found.readings[1], records(found)["readings"][1]
    assert record["reading"] == "field.obstacles=nearest"
    assert sum(block["inside"] for block in record["fit"]) == outcome.inside
    assert record["claims"] == outcome.says


def test_verdicts_are_counted_by_environment(found: Findings) -> None:
    count = count_verdicts(records(found), "env2", "does not hold")
    assert count == sum(j.claim.map == "env2" and j.verdict == "does not hold" for j in found.claims) > 0
