"""A store of a hundred thousand runs: looking something up costs what is asked for, not what is there.

That is counted in runs that MLflow loads, two milliseconds each.
"""

from __future__ import annotations

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.tracking.mlflow.run import RunWriter
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

RUNS, OF_ONE = 100_000, 2_500
"""Runs in the store; those of the configuration that is asked for, whose seeds are 0, 1, 2, ..."""
SETUP = Setup.of(
    resolve("aco", {"iterations": 4, "ants": 2}), Grid([[0, 0, 0], [0, 1, 0], [0, 0, 0]], name="yard")
)


def fill(file: Path) -> None:
    """Copy the one run of a store as often as is wanted: of its configuration, and of others."""
    with closing(sqlite3.connect(file)) as database, database:
        database.execute("PRAGMA synchronous = OFF")
        database.execute("CREATE TEMP TABLE new (run_uuid TEXT, identity TEXT, cell TEXT, number INTEGER)")
        ours = ((f"{n}", SETUP.identity(n), SETUP.configuration_id, n) for n in range(1, OF_ONE))
        others = ((f"{n}", f"other {n}", f"other {n // 1000}", n) for n in range(OF_ONE, RUNS))
        for rows in (ours, others):
            database.executemany("INSERT INTO new VALUES (?, ?, ?, ?)", rows)
        copy(database, "runs", start_time="runs.start_time + number")
        copy(database, "tags WHERE key = 'identity'", value="new.identity")
        copy(database, "tags WHERE key = 'cell'", value="new.cell")
        copy(database, "tags WHERE key = 'kind'")
        copy(database, "latest_metrics WHERE key IN ('optimum', 'lost_ants')")


def copy(database: sqlite3.Connection, rows: str, **changed: str) -> None:
    """Copy rows of the one run for each new run, with some columns changed."""
    table, _, which = rows.partition(" ")
    columns = [row[1] for row in database.execute(f"PRAGMA table_info({table})")]
    changed["run_uuid"] = "new.run_uuid"
    values = ", ".join(changed.get(column, f"{table}.{column}") for column in columns)
    database.execute(f"INSERT INTO {table} ({', '.join(columns)}) SELECT {values} FROM {table}, new {which}")


@pytest.fixture(scope="module")
def large(blank: Path, tmp_path_factory: pytest.TempPathFactory) -> MlflowTracker:
    """Return a tracker with a large store."""
    file = tmp_path_factory.mktemp("large") / "mlflow.db"
    shutil.copy(blank, file)
    tracker = MlflowTracker(f"sqlite:///{file}")
    tracker.prepare()
    tracker.log(trial(0))
    fill(file)
    return tracker


@pytest.fixture
def loaded(large: MlflowTracker, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return how many runs MLflow loaded for each question that it was asked."""
    counted: list[int] = []
    search = large.store.client.search_runs

    def counting(*args: Any) -> Any:
        page = search(*args)
        counted.append(len(page))
        return page

    monkeypatch.setattr(large.store.client, "search_runs", counting)
    return counted


def trial(seed: int) -> Trial:
    """Return a trial of the configuration that is asked for."""
    return Trial(SETUP, Solver(SETUP.grid, SETUP.settings).solve(seed))


@pytest.fixture
def served(large: MlflowTracker, monkeypatch: pytest.MonkeyPatch) -> MlflowTracker:
    """Return the tracker, asking MLflow as it does a server's."""
    monkeypatch.setattr(large.store, "file", None)
    return large


def test_trials_are_found_without_loading_any(large: MlflowTracker, loaded: list[int]) -> None:
    wanted = {SETUP.identity(seed) for seed in (*range(OF_ONE - 10, OF_ONE), 2_500, 2_501)}
    assert len(large.find(SETUP.configuration_id, wanted)) == 10
    assert not large.has_all(wanted)
    assert large.has_all({SETUP.identity(seed) for seed in range(OF_ONE)})
    assert loaded == []


def test_a_few_trials_are_found_without_loading_all_of_their_configuration(
    served: MlflowTracker, loaded: list[int]
) -> None:
    wanted = {SETUP.identity(seed) for seed in (0, 5, 2_499, 2_500, 2_501)}
    found = served.find(SETUP.configuration_id, wanted)
    assert found.keys() == {SETUP.identity(seed) for seed in (0, 5, 2_499)}
    assert sum(loaded) == 3


def test_many_trials_are_found_by_loading_their_configuration_once(
    served: MlflowTracker, loaded: list[int]
) -> None:
    wanted = {SETUP.identity(seed) for seed in range(0, OF_ONE, 10)}
    assert served.find(SETUP.configuration_id, wanted).keys() == wanted
    assert (sum(loaded), len(loaded)) == (OF_ONE, 3)


def test_making_it_ready_and_keeping_a_trial_load_nothing_else(large: MlflowTracker, loaded: list[int]) -> None:
    large.prepare()
    large.log(trial(20_000))
    assert sum(loaded) == 0  # its tables tell that it is alone


def test_trials_of_batches_are_found_without_loading_single_ones(large: MlflowTracker, loaded: list[int]) -> None:
    seeds = parse_seeds("0-3")
    run = large.begin(SETUP, seeds)
    run.keep(Trials.of([trial(seed).result for seed in seeds]))
    assert Trials.joined(large.find_trials(SETUP.configuration_id, seeds)).seeds.tolist() == [0, 1, 2, 3]
    run.abandon("enough")
    assert sum(loaded) == 1


def test_a_run_of_an_identity_of_many_is_alone_without_loading_others(
    large: MlflowTracker, loaded: list[int]
) -> None:
    writer = RunWriter(large.store, "mine", {}, {"identity": "other 50000", "kind": "trial", "cell": "0" * 16})
    writer.begin()
    writer.finish()
    assert loaded == []
