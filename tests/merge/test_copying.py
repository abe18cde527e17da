"""Runs of one store are copied into another: each identity once, whole, and just as they were."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from acoexp.errors import TrackingError
from acoexp.merge.copying import Merged, merge
from acoexp.tracking.mlflow.store import Store
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.seeds import Seeds
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

Prepared = Callable[[Path], MlflowTracker]


def test_what_is_finished_is_brought_once(
    elsewhere: Path, what: Setup, seeds: Seeds, prepared: Prepared, tmp_path: Path
) -> None:
    here, there = prepared(tmp_path / "mlflow.db"), Store(f"sqlite:///{elsewhere}")
    here.log(Trial(what, Solver(what.grid, what.settings).solve(1)))
    told: list[tuple[int, int]] = []
    assert merge(there, here.store, lambda done, runs: told.append((done, runs))) == Merged(3, 1, 1)
    assert told == [(1, 3), (2, 3), (3, 3)]
    assert merge(there, here.store) == Merged(0, 4, 1)
    assert here.find(what.configuration_id).keys() == {what.identity(which) for which in (0, 1, 2, seeds)}
    assert len(here.store.search("")) == 4


def test_what_is_brought_is_what_was_there(
    elsewhere: Path, what: Setup, seeds: Seeds, prepared: Prepared, tmp_path: Path
) -> None:
    here, there = prepared(tmp_path / "mlflow.db"), MlflowTracker(f"sqlite:///{elsewhere}")
    merge(there.store, here.store)
    by_identity = {run.data.tags["identity"]: run for run in there.store.search("attributes.status = 'FINISHED'")}
    for copy in here.store.search(""):
        original = by_identity[copy.data.tags["identity"]]
        assert copy.data.params == original.data.params
        assert copy.data.metrics == original.data.metrics
        assert copy.info.run_name == original.info.run_name
        assert (copy.info.start_time, copy.info.end_time) == (original.info.start_time, original.info.end_time)
        curves = [
            [(p.step, p.value) for p in t.store.client.get_metric_history(run.info.run_id, "best_length")]
            for t, run in ((here, copy), (there, original))
        ]
        assert curves[0] == curves[1]
    batch = Trials.joined(here.find_trials(what.configuration_id, seeds))
    one_by_one = Solver(what.grid, what.settings).solve_many(seeds)
    assert batch.table.tobytes() == Trials.of(one_by_one).table.tobytes()


def test_a_batch_whose_artifacts_are_gone_is_told_of_and_what_was_brought_before_stays(
    elsewhere: Path, what: Setup, prepared: Prepared, tmp_path: Path
) -> None:
    shutil.copy(elsewhere, tmp_path / "alone.db")
    here = prepared(tmp_path / "mlflow.db")
    with pytest.raises(
        TrackingError, match=r"^run \w+ of sqlite:.*alone.db: expected its artifacts in .*got neither"
    ):
        merge(Store(f"sqlite:///{tmp_path}/alone.db"), here.store)
    assert here.find(what.configuration_id).keys() == {what.identity(seed) for seed in range(3)}


def test_a_run_that_is_cut_off_while_it_is_brought_does_not_count(
    elsewhere: Path, what: Setup, seeds: Seeds, prepared: Prepared, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here, there = prepared(tmp_path / "mlflow.db"), Store(f"sqlite:///{elsewhere}")

    def fail(*_: object) -> None:
        raise RuntimeError("disk full")

    with monkeypatch.context() as full:
        full.setattr(here.store.client, "log_artifact", fail)
        with pytest.raises(TrackingError, match="disk full"):
            merge(there, here.store)
    assert what.identity(seeds) not in here.find(what.configuration_id)
    assert [run.data.tags["reason"] for run in here.store.search("attributes.status = 'FAILED'")] != []
    merge(there, here.store)
    assert what.identity(seeds) in here.find(what.configuration_id)
