"""What records say: the same of a trial or a batch that was run as of one that was found in the store."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, StrategyError
from acoexp.command.results.contents import batch_record, found_record, trial_record
from acoexp.command.results.rows import Row, rows_of
from acoexp.registry.resolve import resolve
from acoexp.tracking.mlflow.content import batch_metrics, trial_metrics
from acoexp.tracking.setup import Found, Setup, Trial
from acoexp.trial.features import without_nan
from acoexp.trial.outcome import Batch, Failure
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.table import aggregate
from acoexp.trial.trials import Trials

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SETUP = Setup.of(resolve("aco", {"iterations": 4, "ants": 2}), YARD)
SEEDS = parse_seeds("0-9")


@pytest.fixture(scope="module")
def trials() -> list[Trial]:
    """Return short trials."""
    return [Trial(SETUP, result, 0.002) for result in Solver(YARD, SETUP.settings).solve_many(SEEDS)]


@pytest.fixture(scope="module")
def batch(trials: list[Trial]) -> Batch:
    """Return a batch of these trials, half of which were found."""
    columns = Trials.of([trial.result for trial in trials])
    return Batch(columns.table, *np.zeros((2, 4)), [], ran=5, seconds=0.5)


def metrics(points: Any) -> dict[str, float]:
    """Return metrics as the store has them."""
    return {point.key: point.value for point in points if not point.key.endswith("_length")}


def row(record: dict[str, Any]) -> Row:
    """Return the row of a record that was written and read."""
    (made,) = rows_of([json.loads(json.dumps(without_nan(record)))])
    return made


def test_a_trial_says_everything_and_whose_it_is(trials: list[Trial]) -> None:
    record = trial_record(trials[3])
    assert {key: record[key] for key in trials[3].result.as_dict()} == trials[3].result.as_dict()
    assert (record["seconds"], record["configuration_id"]) == (0.002, SETUP.configuration_id)
    assert record["config"] == {**SETUP.params, "seed": "3"}


def test_a_batch_says_what_its_trials_say_together(batch: Batch) -> None:
    record = batch_record(SETUP, SEEDS, batch)
    assert (record["algo"], record["map"], record["optimum"]) == ("aco", "yard", YARD.optimum)
    assert record["config"] == {**SETUP.params, "seeds": "0-9"}
    assert record["means"] == aggregate(batch.table, YARD.optimum).means
    assert (record["trials"], record["ran"], record["seconds"], record["failed"]) == (10, 5, 0.1, 0)


def test_a_batch_that_was_found_whole_took_no_time(batch: Batch) -> None:
    assert batch_record(SETUP, SEEDS, batch._replace(ran=0, seconds=0.0))["seconds"] is None


def test_a_batch_counts_what_failed(batch: Batch) -> None:
    failed = [Failure(10, StrategyError("the part broke"))]
    assert batch_record(SETUP, parse_seeds("0-10"), batch._replace(failures=failed))["failed"] == 1


def test_a_trial_that_was_found_has_the_row_of_one_that_was_run(trials: list[Trial]) -> None:
    for trial in trials:
        found = Found("trial", 1, metrics(trial_metrics(trial.result)))
        run, known = row(trial_record(trial)), row(found_record(SETUP, trial.result.seed, found))
        assert (run.milliseconds, math.isnan(known.milliseconds)) == (2.0, True)
        np.testing.assert_equal(known._replace(milliseconds=2.0)._asdict(), run._asdict())


def test_a_batch_that_was_found_has_the_row_of_one_that_was_run(batch: Batch) -> None:
    points = metrics(batch_metrics(batch, YARD))
    found = found_record(SETUP, SEEDS, Found("batch", 10, points))
    run = row(batch_record(SETUP, SEEDS, batch))
    np.testing.assert_equal(row(found)._replace(milliseconds=100.0)._asdict(), run._asdict())
    assert run.milliseconds == pytest.approx(100.0)
