"""``tables.json``: the averages, the claims and the readings in full precision."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from acoexp_paper.claims.averages import Average
from acoexp_paper.claims.findings import Findings
from acoexp_paper.claims.pooling import Over
from acoexp_paper.claims.rereading import Outcome, Reread
from acoexp_paper.claims.verdicts import Judged
from acoexp_paper.page.provenance import made_with


def records(found: Findings) -> dict[str, Any]:
    """Return all numbers of the report as plain values; "tables" are the averages of the paper's tables."""
    experiment = found.experiment
    return {
        "made_with": made_with(experiment),
        "trials": experiment.trials,
        "ensemble_trials": experiment.ensemble_trials,
        "reading_trials": experiment.reading_trials,
        "maps": {env: _map(found, env) for env in experiment.maps},
        "tables": [_average(average) for average in found.averages],
        "claims": [_claim(judged) for judged in found.claims],
        "readings": [_reading(outcome) for outcome in found.readings],
    }


def _map(found: Findings, env: str) -> dict[str, Any]:
    experiment = found.experiment
    return {
        "digest": experiment.maps[env].digest,
        "given": env in experiment.given,
        "ensemble": [further.digest for further in experiment.further_maps(env)],
        "scores": found.scores[env].tolist(),
    }


def _average(row: Average) -> dict[str, Any]:
    over_maps = row.over_maps
    return {
        "table": row.printed.table,
        "map": row.printed.map,
        "algorithm": row.printed.algorithm,
        "column": row.printed.column,
        "fitted": row.printed.fitted,
        "published": row.printed.value,
        "first_ten": row.first_ten,
        "mean": row.ours.value,
        "interval": [row.ours.low, row.ours.high],
        "inside": row.inside,
        "mean_over_maps": None if over_maps is None else over_maps.value,
        "interval_over_maps": None if over_maps is None else [over_maps.low, over_maps.high],
        "inside_over_maps": row.inside_over_maps,
    }


def _claim(judged: Judged) -> dict[str, Any]:
    claim = judged.claim
    return {
        "key": claim.key,
        "claim": claim.text,
        "where": claim.where,
        "map": claim.map,
        "fitted": claim.fitted,
        "measure": claim.kind.measure,
        "published": judged.published,
        "on_maps": [{"effect": effect.value, "noise": effect.noise} for effect in judged.effects],
        "over_maps": _over(judged.over),
        "weighted": None if judged.weighted is None else _over(judged.weighted),
        "p": judged.p,
        "p_holm": judged.p_holm,
        "verdict": judged.verdict,
    }


def _over(over: Over) -> dict[str, Any]:
    return {
        "effect": over.mean.value,
        "interval": [over.mean.low, over.mean.high],
        "next": None if over.next is None else list(over.next),
        "spread": over.spread,
        "maps": over.maps,
        "p_between": over.p_between,
    }


def _reading(outcome: Outcome) -> dict[str, Any]:
    return {
        "reading": outcome.reading.text,
        "maps": outcome.maps,
        "fit": [
            {"table": table, "map": env, "algorithm": algo, "inside": inside, "of": of}
            for (table, env, algo), (inside, of) in outcome.fit.items()
        ],
        "claims": {key: _reread(reread, key in outcome.changed) for key, reread in outcome.claims.items()},
    }


def _reread(reread: Reread, changed: bool) -> dict[str, Any]:
    value, low, high = reread.change
    return {
        "over_maps": _over(reread.judged.over),
        "verdict": reread.judged.verdict,
        "change": value,
        "change_interval": [low, high],
        "p_of_change": reread.p,
        "changed": changed,
    }


def count_verdicts(records: Mapping[str, Any], env: str, verdict: str) -> int:
    """Return how many claims about an environment, of those that its maps were not fitted to, have a verdict."""
    return sum(
        claim["map"] == env and claim["verdict"] == verdict and not claim["fitted"] for claim in records["claims"]
    )
