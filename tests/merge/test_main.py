"""Runs of one store brought into another by the command, each identity once."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from running import listing

from acoexp import Grid
from acoexp.merge.__main__ import main
from acoexp.registry.resolve import resolve
from acoexp.runs.batch import keep_batch
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
WHAT = Setup.of(resolve("aco", {"iterations": 4, "ants": 2}), YARD)
SEEDS = parse_seeds("0-9")


def prepared(file: Path) -> MlflowTracker:
    """Return a store in a file, ready."""
    tracker = MlflowTracker(f"sqlite:///{file}")
    tracker.prepare()
    return tracker


@pytest.fixture(scope="module")
def elsewhere(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The store of another machine, with three trials, a batch and a failure; moved here with its artifacts."""
    folder = tmp_path_factory.mktemp("other")
    tracker = prepared(folder / "there" / "mlflow.db")
    for result in Solver(YARD, WHAT.settings).solve_many(range(3)):
        tracker.log(Trial(WHAT, result))
    tracker.log_failure(WHAT, 7, "the part broke")
    keep_batch(WHAT, SEEDS, tracker)
    shutil.move(folder / "there", folder / "here")
    return folder / "here" / "mlflow.db"


def test_what_is_finished_is_brought_once(
    elsewhere: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    here = prepared(tmp_path / "mlflow.db")
    here.log(Trial(WHAT, Solver(YARD, WHAT.settings).solve(1)))
    for said in ("3 runs brought", "0 runs brought"):
        main([str(elsewhere), "--into", str(tmp_path / "mlflow.db")])
        assert said in capsys.readouterr().out
    assert here.find(WHAT.configuration_id).keys() == {WHAT.identity(seeds) for seeds in (0, 1, 2, SEEDS)}
    assert len(here.store.search("")) == 4


def test_what_is_brought_is_what_was_there(elsewhere: Path, tmp_path: Path) -> None:
    main([str(elsewhere), "--into", f"sqlite:///{tmp_path}/mlflow.db"])
    here, there = MlflowTracker(f"sqlite:///{tmp_path}/mlflow.db"), MlflowTracker(f"sqlite:///{elsewhere}")
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
    batch = Trials.joined(here.find_trials(WHAT.configuration_id, SEEDS))
    assert batch.table.tobytes() == Trials.of(Solver(YARD, WHAT.settings).solve_many(SEEDS)).table.tobytes()


def test_a_batch_whose_artifacts_are_gone_is_told_of(
    elsewhere: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(elsewhere, tmp_path / "alone.db")
    with pytest.raises(SystemExit, match="1"):
        main([str(tmp_path / "alone.db"), "--into", f"sqlite:///{tmp_path}/mlflow.db"])
    said = capsys.readouterr().err
    assert said.startswith("acoexp: error: run ")
    assert "expected its artifacts in " in said
    finished = MlflowTracker(f"sqlite:///{tmp_path}/mlflow.db").find(WHAT.configuration_id)
    assert finished.keys() == {WHAT.identity(seed) for seed in range(3)}


@pytest.mark.parametrize("source", ["nowhere.db", "sqlite:///nowhere.db", "sqlite://"])
def test_a_store_that_is_not_there_is_refused_and_not_made(
    source: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit, match="1"):
        main([source])
    assert "expected" in capsys.readouterr().err
    assert listing(tmp_path) == set()


def test_a_store_is_not_merged_into_itself(elsewhere: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="1"):
        main([str(elsewhere), "--into", f"sqlite:///{elsewhere}"])
    assert "expected a store other than the one" in capsys.readouterr().err
