"""``tables.json``: the averages, the claims and the readings in full precision."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from acoexp_paper.claims.averages import Average
from acoexp_paper.claims.findings import Findings, Outcome
from acoexp_paper.claims.kinds import Finding
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.trials.experiment import Experiment


def records(found: Findings) -> dict[str, Any]:
    """Return all numbers of the report as plain values; "tables" are the averages of the paper's tables."""
    experiment = found.experiment
    return {
        "trials": experiment.trials,
        "ensemble_trials": experiment.ensemble_trials,
        "maps": {env: _map(experiment, env) for env in experiment.maps},
        "tables": [_average(average) for average in found.averages],
        "claims": [_claim(judged) for judged in found.claims],
        "readings": [_reading(outcome) for outcome in found.readings],
    }


def _map(experiment: Experiment, env: str) -> dict[str, Any]:
    return {
        "digest": experiment.maps[env].digest,
        "given": env in experiment.given,
        "ensemble": [further.digest for further in experiment.further_maps(env)],
    }


def _average(row: Average) -> dict[str, Any]:
    return {
        "table": row.printed.table,
        "map": row.printed.map,
        "algorithm": row.printed.algorithm,
        "column": row.printed.column,
        "published": row.printed.value,
        "first_ten": row.first_ten,
        "mean": row.ours.value,
        "interval": [row.ours.low, row.ours.high],
        "inside": row.inside,
        "ensemble_mean": None if row.ensemble is None else row.ensemble.value,
        "ensemble_interval": None if row.ensemble is None else [row.ensemble.low, row.ensemble.high],
        "ensemble_inside": row.ensemble_inside,
    }


def _claim(judged: Judged) -> dict[str, Any]:
    claim, finding, over_maps = judged.claim, judged.finding, judged.over_maps
    return {
        "key": claim.key,
        "claim": claim.text,
        "where": claim.where,
        "map": claim.map,
        "fitted": claim.fitted,
        **_test(finding),
        "p_holm": judged.p_holm,
        **_effect(finding),
        "on_map": judged.on_map,
        "maps": list(judged.says),
        "over_maps": None if over_maps is None else {**_test(over_maps), **_effect(over_maps)},
        "verdict": judged.verdict,
    }


def _test(finding: Finding) -> dict[str, Any]:
    return {"statistic": finding.statistic, "p": finding.p}


def _effect(finding: Finding) -> dict[str, Any]:
    value, low, high = finding.effect
    return {"measure": finding.measure, "effect": value, "interval": [low, high]}


def _reading(outcome: Outcome) -> dict[str, Any]:
    return {
        "reading": outcome.reading.text,
        "fit": [
            {"table": table, "map": env, "algorithm": algo, "inside": inside, "of": of}
            for (table, env, algo), (inside, of) in outcome.fit.items()
        ],
        "claims": outcome.says,
    }


def count_verdicts(records: Mapping[str, Any], env: str, verdict: str) -> int:
    """Return how many claims about an environment have a verdict."""
    return sum(claim["map"] == env and claim["verdict"] == verdict for claim in records["claims"])
