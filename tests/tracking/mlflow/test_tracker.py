"""Trials and batches in an MLflow store: whole or marked as failed, and found again."""

from __future__ import annotations

import dataclasses
import logging
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mlflow.entities import Run

from acoexp import Grid
from acoexp.errors import StrategyError, TrackingError
from acoexp.registry.resolve import resolve
from acoexp.tracking.mlflow.run import RunWriter
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Found, Setup, Trial
from acoexp.trial.outcome import Batch, Failure
from acoexp.trial.result import Result
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.table import TABLE, csv_lines
from acoexp.trial.trials import Trials

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SEEDS = parse_seeds("0-9")
LEAST = {"optimum", "any_angle_optimum", "cycles", "lost_ants", "ant_steps"}
"""Metrics of a trial in which no ant arrived."""


def setup(rho: float, **settings: Any) -> Setup:
    """Return a setup of quick trials; its rho tells it from those of other tests."""
    return Setup.of(resolve("aco", {"iterations": 4, "ants": 2, "rho": rho, **settings}), YARD)


def results(what: Setup, seeds: Seeds = SEEDS) -> list[Result]:
    """Return a setup's trials, run one by one."""
    return Solver(what.grid, what.settings).solve_many(seeds)


def trial(what: Setup, seed: int = 0) -> Trial:
    """Return a trial of a setup."""
    return Trial(what, Solver(what.grid, what.settings).solve(seed))


def runs_of(tracker: MlflowTracker, what: Setup) -> list[Run]:
    """Return all runs of a setup that are not deleted."""
    return tracker.store.search(f"tags.cell = '{what.configuration_id}'")


def found(tracker: MlflowTracker, what: Setup, *seeds: int | Seeds) -> dict[str, Found]:
    """Return what is found of the trials with some seeds, or the batches of some."""
    return tracker.find(what.configuration_id, {what.identity(each) for each in seeds})


def kept(tracker: MlflowTracker, what: Setup, seeds: Seeds = SEEDS) -> list[Trials]:
    """Return the trials that a store has of a batch, as they were kept."""
    return list(tracker.find_trials(what.configuration_id, seeds))


# --- trials


def test_a_trial_is_one_finished_run(tracker: MlflowTracker) -> None:
    one = trial(setup(0.01), seed=3)
    tracker.log(one)
    (run,) = runs_of(tracker, one.setup)
    assert (run.info.status, run.info.run_name) == ("FINISHED", "aco yard seed 3")
    assert run.data.params == one.params
    assert run.data.metrics["l1"] == one.result.l1
    tags = run.data.tags
    assert (tags["identity"], tags["kind"], tags["map.digest"]) == (one.identity, "trial", YARD.digest)
    assert tags["update.package"].startswith("acoexp ")


def test_a_trial_that_was_kept_is_found_under_its_identity(tracker: MlflowTracker) -> None:
    one = trial(setup(0.02), seed=3)
    assert (found(tracker, one.setup, 3), tracker.has(one.identity)) == ({}, False)
    tracker.log(one)
    (run,) = found(tracker, one.setup, 3).values()
    assert (run.kind, run.trials, run.metrics["l1"]) == ("trial", 1, one.result.l1)
    assert tracker.has(one.identity)


def test_a_run_carries_its_artifacts_before_it_is_finished(
    tracker: MlflowTracker, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    one = dataclasses.replace(trial(setup(0.021)), artifacts={"path.csv": b"x", "path.png": b"y"})
    with monkeypatch.context() as killed:
        killed.setattr(RunWriter, "log_files", lambda *_: 1 / 0)
        with pytest.raises(ZeroDivisionError):
            tracker.log(one)
    assert not tracker.has(one.identity)
    tracker.log(one)
    (run,) = [run for run in runs_of(tracker, one.setup) if run.info.status == "FINISHED"]
    folder = tracker.store.client.download_artifacts(run.info.run_id, "", str(tmp_path))
    assert {file.name: file.read_bytes() for file in Path(folder).iterdir()} == one.artifacts


def test_trials_are_looked_for_in_their_own_experiment(tracker: MlflowTracker) -> None:
    other = MlflowTracker(tracker.store.uri, "another one")
    other.prepare()
    one = trial(setup(0.022))
    other.log(one)
    assert (other.has(one.identity), other.has_all([one.identity])) == (True, True)
    assert (tracker.has(one.identity), tracker.has_all([one.identity])) == (False, False)
    assert other.where.startswith("MLflow experiment 'another one' at ")


def test_where_no_ant_ever_arrived_the_run_is_finished_all_the_same(tracker: MlflowTracker) -> None:
    one = trial(setup(0.03))
    lost = dataclasses.replace(one.result, curve_pairs=np.full((4, 2), -1, dtype=np.int32), moves=None)
    tracker.log(Trial(one.setup, lost))
    assert set(found(tracker, one.setup, 0)[one.identity].metrics) == LEAST


def test_the_same_trial_is_kept_once_unless_it_is_to_take_the_place_of_the_one_before(
    tracker: MlflowTracker, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.INFO, "acoexp.tracking")
    one = trial(setup(0.04))
    tracker.log(one)
    assert caplog.messages == []
    tracker.log(one)
    assert caplog.messages == ["aco on yard, seed 0: found in the store, which keeps one run of it"]
    (run,) = runs_of(tracker, one.setup)
    tracker.log(one, resume=False)
    (newer,) = runs_of(tracker, one.setup)
    assert newer.info.run_id != run.info.run_id
    assert found(tracker, one.setup, 0).keys() == {one.identity}


def test_a_trial_that_failed_is_kept_with_its_reason_and_not_found(tracker: MlflowTracker) -> None:
    what = setup(0.05)
    tracker.log_failure(what, 3, "the part broke")
    (run,) = runs_of(tracker, what)
    assert (run.info.status, run.data.tags["reason"], run.data.params["seed"]) == ("FAILED", "the part broke", "3")
    assert found(tracker, what, 3) == {}


@pytest.mark.parametrize("failure", [RuntimeError("disk full\nand more"), KeyboardInterrupt()])
def test_a_run_that_cannot_be_kept_whole_is_marked_as_failed(
    tracker: MlflowTracker, failure: BaseException, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise failure

    one = trial(setup(0.06, q=1.0 + isinstance(failure, KeyboardInterrupt)))
    with monkeypatch.context() as full:
        full.setattr(tracker.store.client, "log_batch", fail)
        with pytest.raises((TrackingError, KeyboardInterrupt)) as caught:
            tracker.log(one)
    assert [run.info.status for run in runs_of(tracker, one.setup)] == ["FAILED"]
    if isinstance(caught.value, TrackingError):
        assert str(caught.value).endswith("does not take a trial: disk full")


def test_a_store_that_was_never_prepared_takes_no_trial(fresh: str) -> None:
    with pytest.raises(TrackingError, match=r"no experiment 'acoexp' at sqlite"):
        MlflowTracker(fresh).log(trial(setup(0.07)))


def test_two_finished_runs_of_one_identity_become_one_when_they_are_found(
    tracker: MlflowTracker, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = trial(setup(0.08))
    with monkeypatch.context() as killed:  # right after it was finished
        killed.setattr(RunWriter, "_keep_only_this", lambda self, run_id: None)
        for _ in range(2):
            tracker.log(one, resume=False)
    assert len(runs_of(tracker, one.setup)) == 2
    assert found(tracker, one.setup, 0).keys() == {one.identity}
    assert len(runs_of(tracker, one.setup)) == 1


# --- batches


def batch_of(trials: Trials) -> Batch:
    """Return a batch of trials that were all run, in half a second each."""
    return Batch(trials.table, trials.curves[0], trials.curves[0], [], len(trials), len(trials) / 2)


def test_a_batch_is_one_run_with_its_aggregates_and_its_table(tracker: MlflowTracker, tmp_path: Path) -> None:
    what = setup(0.11)
    trials = Trials.of(results(what))
    log = tracker.begin(what, SEEDS)
    log.keep(trials)
    log.finish(batch_of(trials), {})
    (run,) = runs_of(tracker, what)
    assert (run.info.status, run.info.run_name) == ("FINISHED", "aco yard seeds 0-9")
    assert run.data.params == {**what.params, "seeds": "0-9"}
    assert (run.data.metrics["trials"], run.data.metrics["failed"]) == (10.0, 0.0)
    csv = tracker.store.client.download_artifacts(run.info.run_id, "trials.csv", str(tmp_path))
    assert Path(csv).read_text("utf-8").splitlines() == list(csv_lines(trials.table))
    (batch,) = found(tracker, what, SEEDS).values()
    assert (batch.kind, batch.trials) == ("batch", 10)


def test_a_batch_with_trials_that_failed_says_which_and_has_failed(tracker: MlflowTracker, tmp_path: Path) -> None:
    what = setup(0.12)
    failures = [Failure(4, StrategyError("the part broke")), Failure(7, StrategyError("so did this"))]
    tracker.begin(what, SEEDS).finish(Batch(np.zeros(0, TABLE), *np.zeros((2, 4)), failures, 0, 0.0), {})
    (run,) = runs_of(tracker, what)
    assert (run.info.status, run.data.tags["reason"]) == ("FAILED", "2 trials failed: the part broke")
    said = tracker.store.client.download_artifacts(run.info.run_id, "failed.txt", str(tmp_path))
    assert Path(said).read_text("utf-8") == "4: the part broke\n7: so did this\n"


def test_a_batch_whose_seeds_are_too_long_for_a_param_is_found_as_any_other(tracker: MlflowTracker) -> None:
    what, many = setup(0.125), parse_seeds(",".join(str(2 * n) for n in range(300)))
    trials = Trials.of(results(what, many))
    log = tracker.begin(what, many)
    log.keep(trials)
    log.finish(batch_of(trials), {})
    (run,) = runs_of(tracker, what)
    assert (run.data.params.get("seeds"), len(run.info.run_name or "")) == (None, 250)
    assert found(tracker, what, many)[what.identity(many)].trials == 300
    assert Trials.joined(kept(tracker, what, many)).table.tobytes() == trials.table.tobytes()


def test_a_batch_that_lost_its_trials_says_so(tracker: MlflowTracker, caplog: pytest.LogCaptureFixture) -> None:
    what = setup(0.126)
    trials = Trials.of(results(what))
    tracker.begin(what, SEEDS).finish(batch_of(trials), {})
    assert kept(tracker, what) == []
    (said,) = caplog.messages
    assert ": its trials are no longer in file://" in said


def test_trials_are_found_by_their_seeds_in_whatever_batch_each_once(tracker: MlflowTracker) -> None:
    what = setup(0.13)
    every = results(what, parse_seeds("0-19"))
    for seeds in ("0-9", "5-14", "15-19"):
        first, last = (int(seed) for seed in seeds.split("-"))
        tracker.begin(what, parse_seeds(seeds)).keep(Trials.of(every[first : last + 1]))
    wanted = parse_seeds("3-12,99")
    portions = kept(tracker, what, wanted)
    assert sorted(seed for portion in portions for seed in portion.seeds.tolist()) == list(range(3, 13))
    assert Trials.joined(portions).table.tobytes() == Trials.of(every[3:13]).table.tobytes()
    assert kept(tracker, what, parse_seeds("50-60")) == []


def test_trials_of_another_configuration_are_not_found(tracker: MlflowTracker) -> None:
    what = setup(0.14)
    tracker.begin(what, SEEDS).keep(Trials.of(results(what)))
    assert kept(tracker, setup(0.141)) == []


def test_a_portion_that_was_cut_off_is_left_out_with_a_warning(
    tracker: MlflowTracker, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    what = setup(0.15)
    tracker.begin(what, SEEDS).keep(Trials.of(results(what)[:5]))
    (run,) = runs_of(tracker, what)
    damaged = tmp_path / "00001.npz"
    damaged.write_bytes(Trials.of(results(what)[5:]).to_bytes()[:-30])
    tracker.store.client.log_artifact(run.info.run_id, str(damaged), "trials")
    assert Trials.joined(kept(tracker, what)).seeds.tolist() == [0, 1, 2, 3, 4]
    assert [said for said in caplog.messages if said.endswith("trials/00001.npz is damaged and is left out")]


def test_of_a_batch_that_two_kept_at_once_the_trials_of_one_stay(
    tracker: MlflowTracker, monkeypatch: pytest.MonkeyPatch
) -> None:
    what, looking = setup(0.19), []
    trials = Trials.of(results(what))
    keep_only_this = RunWriter._keep_only_this
    with monkeypatch.context() as late:  # both are finished before either looks for the other
        late.setattr(RunWriter, "_keep_only_this", lambda self, run_id: looking.append((self, run_id)))
        for _ in range(2):
            log = tracker.begin(what, SEEDS)
            log.keep(trials)
            log.finish(batch_of(trials), {})
    assert [run.info.status for run in runs_of(tracker, what)] == ["FINISHED"] * 2
    for writer, run_id in looking:
        keep_only_this(writer, run_id)
    assert [run.info.status for run in runs_of(tracker, what)] == ["FINISHED"]
    assert Trials.joined(kept(tracker, what)).table.tobytes() == trials.table.tobytes()
