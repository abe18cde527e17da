"""Records: the trials of one job are run, kept in the store, and leave their record in the job's folder."""

from __future__ import annotations

import json
import math
import time
from pathlib import Path
from typing import Any

import numpy as np

from acoexp.batch import Batch
from acoexp.errors import StrategyError
from acoexp.seeds import Seeds
from acoexp.solver import Solver
from acoexp.tracking import Setup, Tracker, Trial
from acoexp.tracking.kept_batch import keep_batch
from acoexp.trials import aggregate, csv_lines

TRIAL, BATCH, PROGRESS = "trial.json", "batch.json", "progress"
"""Files in a job's folder: the record of a finished trial, or of a finished batch; how far a batch is."""


def run_trial_job(setup: Setup, seed: int, tracker: Tracker, folder: Path, *, anew: bool, pictures: bool) -> float:
    """Run one trial, keep it, and write its record and, if asked for, its pictures; return its best length."""
    began = time.perf_counter()
    try:
        solver = Solver(setup.grid, setup.settings)
        began = time.perf_counter()
        result = solver.solve(seed)
    except StrategyError as problem:
        tracker.log_failure(setup, seed, str(problem))
        raise
    seconds = time.perf_counter() - began
    if pictures:
        from acoexp.command.pictures import draw_convergence, draw_map

        draw_map(result, folder / "path.png")
        draw_convergence(result, folder / "convergence.png")
    trial = Trial(setup, result)
    content = {**result.as_dict(), "seconds": seconds, "cell": setup.cell, "config": trial.params}
    _write(folder / TRIAL, json.dumps(content))
    tracker.log(trial, anew=anew)
    return result.length if result.path is not None else math.inf


def run_batch_job(
    setup: Setup, seeds: Seeds, tracker: Tracker, folder: Path, *, threads: int | None, anew: bool
) -> float:
    """Run what is missing of a batch, keep it, and write its record and table; return the mean best length.

    Raises:
        StrategyError: if any of its trials failed; all others have been run and kept.
    """
    batch = keep_batch(
        setup,
        seeds,
        tracker,
        threads=threads,
        resume=not anew,
        tell=lambda done: _write(folder / PROGRESS, str(done)),
    )
    if len(batch.table):
        with (folder / "trials.csv").open("w", encoding="utf-8") as lines:
            lines.writelines(f"{line}\n" for line in csv_lines(batch.table))
        _write(folder / BATCH, json.dumps(_without_nan(_record(setup, seeds, batch))))
    if batch.failures:
        raise StrategyError(f"{len(batch.failures)} of {len(seeds)} trials failed: {batch.failures[0].reason}")
    lengths = batch.table["l1"]
    return math.inf if np.isnan(lengths).any() else float(lengths.mean())


def _record(setup: Setup, seeds: Seeds, batch: Batch) -> dict[str, Any]:
    """Return what a batch found, as plain values for JSON."""
    summary = aggregate(batch.table, setup.grid.optimum, setup.settings.scalars.iterations)
    return {
        "algo": setup.settings.label,
        "map": setup.grid.name,
        "cell": setup.cell,
        "config": {**setup.params, "seeds": str(seeds)},
        "optimum": setup.grid.optimum,
        **summary._asdict(),
        "failed": len(batch.failures),
        "ran": batch.ran,
        "seconds": batch.seconds / batch.ran if batch.ran else None,
    }


def _without_nan(value: Any) -> Any:
    """Return plain values as JSON has them: null where a number is not one."""
    if isinstance(value, dict):
        return {key: _without_nan(inner) for key, inner in value.items()}
    return None if isinstance(value, float) and math.isnan(value) else value


def _write(file: Path, text: str) -> None:
    """Write a file so that it is there whole or not at all; a record's presence says that a job is finished."""
    draft = file.with_suffix(".draft")
    draft.write_text(text, encoding="utf-8")
    draft.replace(file)
