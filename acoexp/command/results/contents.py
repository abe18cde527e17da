"""Recording: what a record says of a trial, of a batch, and of a run that was found in the store."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from acoexp.tracking.setup import Found, Setup, Trial
from acoexp.trial.features import NAMES
from acoexp.trial.outcome import Batch
from acoexp.trial.seeds import Seeds
from acoexp.trial.table import Aggregates, aggregate


def trial_record(trial: Trial) -> dict[str, Any]:
    """Return the record of a trial."""
    return {
        **trial.result.as_dict(),
        "lost_after": trial.result.lost_after,
        "seconds": trial.seconds,
        "configuration_id": trial.setup.configuration_id,
        "config": trial.params,
    }


def batch_record(setup: Setup, seeds: Seeds, batch: Batch) -> dict[str, Any]:
    """Return the record of a batch with at least one finished trial."""
    summary = aggregate(batch.table, setup.grid.optimum)
    in_vain = batch.table[np.isnan(batch.table["l1"])]
    return {
        **_head(setup),
        "lost_after": float(in_vain["ant_steps"].sum() / in_vain["lost_ants"].sum()) if in_vain.size else None,
        "config": {**setup.params, "seeds": str(seeds)},
        **summary._asdict(),
        "failed": len(batch.failures),
        "ran": batch.ran,
        "seconds": batch.seconds / batch.ran if batch.ran else None,
    }


def found_record(setup: Setup, seeds: int | Seeds, found: Found) -> dict[str, Any]:
    """Return the record of a run that was found in the store."""
    metrics, key = found.metrics, "seed" if found.kind == "trial" else "seeds"
    record = {**_head(setup), "config": {**setup.params, key: str(seeds)}, "seconds": None}
    if found.kind == "trial":
        return {**record, **{name: metrics.get(name) for name in NAMES}, "seed": seeds}
    summary = Aggregates(
        trials=found.trials,
        never_arrived=int(metrics["never_arrived"]),
        success_rate=metrics["success_rate"],
        expected_cycles=metrics.get("expected_cycles", math.nan),
        means={name: metrics.get(name, math.nan) for name in NAMES},
        deviations={name: metrics.get(f"{name}_sd", math.nan) for name in NAMES},
    )
    return {**record, **summary._asdict()}


def _head(setup: Setup) -> dict[str, Any]:
    return {
        "algo": setup.settings.label,
        "map": setup.grid.name,
        "configuration_id": setup.configuration_id,
        "optimum": setup.grid.optimum,
    }
