"""Runs of one store are copied into another: each identity once, whole, and just as they were."""

from __future__ import annotations

import shutil
import sqlite3
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import pytest
from mlflow.store.artifact.local_artifact_repo import LocalArtifactRepository

from acoexp.errors import TrackingError
from acoexp.merge.copying import Merged, RefusedError, merge
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
    identities = {what.identity(which) for which in (0, 1, 2, seeds)}
    assert here.find(what.configuration_id, identities).keys() == identities
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


def test_a_trials_artifacts_are_brought_too(what: Setup, prepared: Prepared, tmp_path: Path) -> None:
    there, here = (prepared(tmp_path / place / "mlflow.db") for place in ("there", "here"))
    (result,) = Solver(what.grid, what.settings).solve_many([5])
    there.log(Trial(what, result, artifacts={"path.csv": b"a path", "path.png": b"its picture"}))
    merge(there.store, here.store)
    (run,) = here.store.search("")
    (tmp_path / "brought").mkdir()
    folder = here.store.client.download_artifacts(run.info.run_id, "", str(tmp_path / "brought"))
    assert {file.name: file.read_bytes() for file in Path(folder).iterdir()} == {
        "path.csv": b"a path", "path.png": b"its picture",
    }  # fmt: skip


def test_a_batch_whose_artifacts_are_gone_is_told_of_and_what_was_brought_before_stays(
    elsewhere: Path, what: Setup, prepared: Prepared, tmp_path: Path
) -> None:
    shutil.copy(elsewhere, tmp_path / "alone.db")
    here = prepared(tmp_path / "mlflow.db")
    with pytest.raises(
        TrackingError, match=r"^run \w+ of sqlite:.*alone.db: expected its artifacts in .*got neither"
    ):
        merge(Store(f"sqlite:///{tmp_path}/alone.db"), here.store)
    assert {run.data.tags["identity"] for run in here.store.search("")} == {
        what.identity(seed) for seed in range(3)
    }


def test_a_run_that_is_cut_off_while_it_is_brought_does_not_count(
    elsewhere: Path, what: Setup, seeds: Seeds, prepared: Prepared, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here, there = prepared(tmp_path / "mlflow.db"), Store(f"sqlite:///{elsewhere}")

    def fail(*_: object) -> None:
        raise RuntimeError("disk full")

    with monkeypatch.context() as full:
        full.setattr(LocalArtifactRepository, "log_artifact", fail)
        with pytest.raises(TrackingError, match="disk full"):
            merge(there, here.store)
    assert not here.has(what.identity(seeds))
    assert [run.data.tags["reason"] for run in here.store.search("attributes.status = 'FAILED'")] != []
    merge(there, here.store)
    assert here.has(what.identity(seeds))


@pytest.mark.parametrize("identity", ["x' or tags.identity != '", "", "0" * 31, "0" * 33, "é" * 32])
def test_what_is_no_identity_is_put_into_no_question_to_a_store(
    identity: str, elsewhere: Path, prepared: Prepared, tmp_path: Path
) -> None:
    shutil.copytree(elsewhere.parent, tmp_path / "theirs")
    with closing(sqlite3.connect(tmp_path / "theirs" / "mlflow.db")) as database, database:
        database.execute("UPDATE tags SET value = ? WHERE key = 'identity'", (identity,))
    here = prepared(tmp_path / "mlflow.db")
    assert merge(Store(f"sqlite:///{tmp_path}/theirs/mlflow.db"), here.store) == Merged(0, 0, 5)


def test_that_a_run_took_the_place_of_another_in_its_own_store_counts_for_nothing_here(
    elsewhere: Path, what: Setup, prepared: Prepared, tmp_path: Path
) -> None:
    """A stranger's could say that it is newer than whatever comes after it."""
    shutil.copytree(elsewhere.parent, tmp_path / "theirs")
    with closing(sqlite3.connect(tmp_path / "theirs" / "mlflow.db")) as database, database:
        database.execute("INSERT INTO tags (key, value, run_uuid) SELECT 'anew', '9e99', run_uuid FROM runs")
    here = prepared(tmp_path / "mlflow.db")
    merge(Store(f"sqlite:///{tmp_path}/theirs/mlflow.db"), here.store)
    before = {run.info.run_id for run in here.store.search("")}
    here.log(Trial(what, Solver(what.grid, what.settings).solve(1)), resume=False)
    after = here.store.search(f"tags.identity = '{what.identity(1)}'")
    assert len(after) == 1
    assert after[0].info.run_id not in before


def test_a_run_that_cannot_be_brought_keeps_no_other_back(
    elsewhere: Path, prepared: Prepared, tmp_path: Path
) -> None:
    shutil.copytree(elsewhere.parent, tmp_path / "theirs")
    with closing(sqlite3.connect(tmp_path / "theirs" / "mlflow.db")) as database, database:
        (run_id,) = database.execute("SELECT run_uuid FROM runs WHERE status = 'FINISHED'").fetchone()
        database.execute("UPDATE params SET key = 'x/../../y' WHERE key = 'rho' AND run_uuid = ?", (run_id,))
    here = prepared(tmp_path / "mlflow.db")
    with pytest.raises(RefusedError, match=rf"^run {run_id} of sqlite:") as caught:
        merge(Store(f"sqlite:///{tmp_path}/theirs/mlflow.db"), here.store)
    assert caught.value.merged == Merged(3, 0, 1, 1)


def test_a_reason_that_a_stranger_made_long_is_shortened(
    elsewhere: Path, prepared: Prepared, tmp_path: Path
) -> None:
    shutil.copytree(elsewhere.parent, tmp_path / "theirs")
    with closing(sqlite3.connect(tmp_path / "theirs" / "mlflow.db")) as database, database:
        database.execute("UPDATE runs SET artifact_uri = 'file:///' || replace(hex(zeroblob(4000)), '0', 'x/')")
    with pytest.raises(RefusedError) as caught:
        merge(Store(f"sqlite:///{tmp_path}/theirs/mlflow.db"), prepared(tmp_path / "mlflow.db").store)
    assert len(str(caught.value)) < 5000


def test_of_very_many_that_cannot_be_brought_some_are_named() -> None:
    said = str(RefusedError(Merged(0, 0, 0, 100), [f"run {number}" for number in range(100)]))
    assert said.startswith("run 0; run 1; ")
    assert said.endswith("; run 19; and 80 more")
