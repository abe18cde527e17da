"""``tables.json`` in full precision."""

from __future__ import annotations

from acoexp_paper.claims.findings import Findings
from acoexp_paper.page.records import count_verdicts, records
from small import ENSEMBLE_TRIALS, MAPS, READING_TRIALS, TRIALS


def test_an_average_is_there_as_it_was_found(found: Findings) -> None:
    number, row = next((n, row) for n, row in enumerate(found.averages) if row.inside != row.inside_over_maps)
    record = records(found)["tables"][number]
    assert (record["table"], record["map"], record["algorithm"], record["column"]) == row.printed[:4]
    assert (record["published"], record["first_ten"]) == (row.printed.value, row.first_ten)
    assert (record["mean"], *record["interval"]) == row.ours
    assert (record["mean_over_maps"], *record["interval_over_maps"]) == row.over_maps
    assert (record["inside"], record["inside_over_maps"]) == (row.inside, row.inside_over_maps)


def test_a_claim_is_there_with_its_effect_on_each_map_and_over_all(found: Findings) -> None:
    judged, record = found.claims[0], records(found)["claims"][0]
    assert (record["key"], record["verdict"]) == (judged.claim.key, judged.verdict)
    assert [(on["effect"], on["noise"]) for on in record["on_maps"]] == list(judged.effects)
    assert (record["over_maps"]["effect"], *record["over_maps"]["interval"]) == judged.over.mean
    assert record["over_maps"]["next"] == list(judged.over.next or ())
    assert (record["p"], record["p_holm"]) == (judged.p, judged.p_holm)
    assert judged.weighted is not None
    assert record["weighted"]["effect"] == judged.weighted.mean.value


def test_what_was_left_out_is_null(found: Findings) -> None:
    over = found.claims[0].over._replace(next=None)
    alone = found._replace(
        averages=[found.averages[0]._replace(over_maps=None)],
        claims=[found.claims[0]._replace(weighted=None, over=over)],
        readings=[],
    )
    record = records(alone)
    (average,), (claim,) = record["tables"], record["claims"]
    assert (average["mean_over_maps"], average["interval_over_maps"], average["inside_over_maps"]) == (None,) * 3
    assert (claim["over_maps"]["next"], claim["weighted"], record["readings"]) == (None, None, [])


def test_the_trials_and_maps_behind_it_are_named(found: Findings) -> None:
    record = records(found)
    trials = [record[name] for name in ("trials", "ensemble_trials", "reading_trials")]
    assert trials == [TRIALS, ENSEMBLE_TRIALS, READING_TRIALS]
    assert record["maps"]["env2"]["digest"] == found.experiment.maps["env2"].digest
    assert len(set(record["maps"]["env2"]["ensemble"])) == MAPS
    assert record["maps"]["fig13"]["scores"] == found.scores["fig13"].tolist()


def test_a_reading_is_there_with_its_fit_by_block_and_its_claims(found: Findings) -> None:
    (outcome,), (record,) = found.readings, records(found)["readings"]
    assert record["reading"] == "field.obstacles=nearest"
    assert sum(block["inside"] for block in record["fit"]) == outcome.inside
    key, again = next(iter(outcome.claims.items()))
    assert record["claims"][key]["verdict"] == again.judged.verdict
    assert record["claims"][key]["changed"] == (key in outcome.changed)


def test_verdicts_are_counted_by_environment_without_fitted_claims(found: Findings) -> None:
    verdict = next(judged.verdict for judged in found.counted if judged.claim.map == "env2")
    count = count_verdicts(records(found), "env2", verdict)
    assert count == sum(j.claim.map == "env2" and j.verdict == verdict for j in found.counted) > 0
