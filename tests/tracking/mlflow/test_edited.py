"""Runs that a person edited, in the browser or in the database: none blocks a command, whatever was done to it."""

from __future__ import annotations

import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from mlflow.entities import Run

from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.runs.batch import keep_batch
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

WHAT = Setup.of(resolve("aco", {"iterations": 4, "ants": 2}), Grid([[0, 0, 0], [0, 1, 0], [0, 0, 0]], name="yard"))
SEEDS = parse_seeds("0-3")
RESULTS = Solver(WHAT.grid, WHAT.settings).solve_many(SEEDS)

Edit = Callable[[MlflowTracker, Run], None]

TAGS = ("identity", "cell", "kind", "owner", "writer", "alive", "anew", "reason", "map.digest")
TEXTS = ("", "alice", "9" * 400)


def written_over(tag: str, text: str) -> Edit:
    def edit(tracker: MlflowTracker, run: Run) -> None:
        tracker.store.client.set_tag(run.info.run_id, tag, text)

    return edit


def tag_deleted(tag: str) -> Edit:
    def edit(tracker: MlflowTracker, run: Run) -> None:
        if tag in run.data.tags:
            tracker.store.client.delete_tag(run.info.run_id, tag)

    return edit


def by_sql(statement: str) -> Edit:
    def edit(tracker: MlflowTracker, run: Run) -> None:
        with closing(sqlite3.connect(tracker.store.file or "")) as database, database:
            database.execute(f"{statement} run_uuid = ?", (run.info.run_id,))

    return edit


def renamed(tracker: MlflowTracker, run: Run) -> None:
    tracker.store.client.update_run(run.info.run_id, name="my favourite")


def deleted(tracker: MlflowTracker, run: Run) -> None:
    tracker.store.client.delete_run(run.info.run_id)


def without_its_artifacts(tracker: MlflowTracker, run: Run) -> None:
    shutil.rmtree(tracker.store.folder / "artifacts" if tracker.store.folder else "", ignore_errors=True)


OTHERS: dict[str, Edit] = {
    "renamed": renamed,
    "deleted": deleted,
    "without its artifacts": without_its_artifacts,
    "seeds that are none": by_sql("UPDATE params SET value = 'many' WHERE key LIKE 'seed%' AND"),
    "no params": by_sql("DELETE FROM params WHERE"),
    "no metrics": by_sql("DELETE FROM latest_metrics WHERE"),
    "metrics that are none": by_sql("UPDATE latest_metrics SET is_nan = 1 WHERE"),
    "infinite metrics": by_sql("UPDATE latest_metrics SET value = 1e308 * 10 WHERE"),
    "no tags": by_sql("DELETE FROM tags WHERE"),
    "no time": by_sql("UPDATE runs SET start_time = 0, end_time = NULL WHERE"),
}
EDITS = {
    **{f"{tag}={text[:9]}": written_over(tag, text) for tag in TAGS for text in TEXTS},
    **{f"no {tag}": tag_deleted(tag) for tag in TAGS},
    **OTHERS,
}


@pytest.fixture(scope="module")
def kept(blank: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a store with a trial, a batch, and a batch that has begun."""
    home = tmp_path_factory.mktemp("kept") / "outputs"
    home.mkdir()
    shutil.copy(blank, home / "mlflow.db")
    tracker = opened(home)
    tracker.log(Trial(WHAT, RESULTS[0]))
    keep_batch(WHAT, SEEDS, tracker)
    tracker.begin(WHAT, parse_seeds("0-9")).keep(Trials.of(RESULTS[2:]))
    return home


def opened(home: Path) -> MlflowTracker:
    """Return a tracker with the store in a folder, as the next command opens it."""
    tracker = MlflowTracker(f"sqlite:///{home}/mlflow.db")
    tracker.prepare()
    return tracker


@pytest.mark.parametrize("edit", EDITS.values(), ids=EDITS)
def test_commands_go_on_and_find_or_run_what_is_asked_for(edit: Edit, kept: Path, tmp_path: Path) -> None:
    shutil.copytree(kept, tmp_path / "outputs")
    tracker = opened(tmp_path / "outputs")
    for run in tracker.store.search(""):
        edit(tracker, run)
    tracker = opened(tmp_path / "outputs")
    if not tracker.has(WHAT.identity(0)):
        tracker.log(Trial(WHAT, RESULTS[0]))
    batch = keep_batch(WHAT, SEEDS, tracker)
    assert batch.table.tobytes() == Trials.of(RESULTS).table.tobytes()
    found = tracker.find(WHAT.configuration_id, {WHAT.identity(0), WHAT.identity(SEEDS)})
    assert {run.kind: run.trials for run in found.values()} == {"trial": 1, "batch": 4}
    assert all(np.isfinite(run.metrics["optimum"]) for run in found.values())
