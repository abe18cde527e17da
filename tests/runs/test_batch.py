"""Batches in a store: whole, resumed after a kill, and one finished run for each identity whoever writes."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from mlflow.entities import Run
from running import environment

from acoexp import Grid, solve_many
from acoexp.errors import StoreGoneError, StrategyError
from acoexp.registry.resolve import resolve
from acoexp.runs.batch import keep_batch
from acoexp.tracking.mlflow.run import RunWriter
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.trial.result import Result
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.table import aggregate, csv_lines
from acoexp.trial.trials import Trials

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SEEDS = parse_seeds("0-9")
SETTLE = RunWriter._keep_only_this


def setup(**settings: Any) -> Setup:
    """Return a setup of quick trials."""
    return Setup.of(resolve("aco", {"iterations": 4, "ants": 2, **settings}), YARD)


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> MlflowTracker:
    """Return a store that is ready; tests tell their trials apart by rho."""
    tracker = MlflowTracker(f"sqlite:///{tmp_path_factory.mktemp('store')}/mlflow.db")
    tracker.prepare()
    return tracker


def runs_of(tracker: MlflowTracker, what: Setup) -> list[Run]:
    """Return all runs of a setup that are not deleted."""
    return tracker.store.search(f"tags.cell = '{what.configuration_id}'")


def results(what: Setup, seeds: Seeds = SEEDS) -> list[Result]:
    """Return a setup's trials, run one by one."""
    return Solver(what.grid, what.settings).solve_many(seeds)


def kept(tracker: MlflowTracker, what: Setup, seeds: Seeds = SEEDS) -> Trials:
    """Return the trials that a store has of a batch."""
    return Trials.joined(tracker.find_trials(what.configuration_id, seeds))


def test_a_batch_is_one_run_with_aggregates_and_a_table(store: MlflowTracker, tmp_path: Path) -> None:
    what = setup(rho=0.11)
    batch = keep_batch(what, SEEDS, store)
    (run,) = runs_of(store, what)
    assert (run.info.status, run.info.run_name) == ("FINISHED", "aco yard seeds 0-9")
    assert run.data.params["seeds"] == "0-9"
    assert "seed" not in run.data.params
    one_by_one = results(what)
    assert run.data.metrics["trials"] == 10
    assert run.data.metrics["lost_ants"] == sum(r.lost_ants.sum() for r in one_by_one) / 10
    assert run.data.metrics["success_rate"] == sum(r.found_optimum for r in one_by_one) / 10
    client = store.store.client
    csv = Path(client.download_artifacts(run.info.run_id, "trials.csv", str(tmp_path))).read_text("utf-8")
    assert csv.count("\n") == 11
    history = client.get_metric_history(run.info.run_id, "best_length")
    assert {point.step: point.value for point in history} == dict(enumerate(batch.curve.tolist(), 1))
    assert kept(store, what).table.tobytes() == batch.table.tobytes() == Trials.of(one_by_one).table.tobytes()


def test_the_same_batch_again_runs_nothing(store: MlflowTracker) -> None:
    what = setup(rho=0.12)
    first = keep_batch(what, SEEDS, store)
    again = keep_batch(what, SEEDS, store)
    assert (first.ran, again.ran) == (10, 0)
    assert again.table.tobytes() == first.table.tobytes()
    assert len(runs_of(store, what)) == 1


def test_a_larger_batch_runs_what_is_missing(store: MlflowTracker) -> None:
    what, larger = setup(rho=0.13), parse_seeds("5-19,30")
    keep_batch(what, SEEDS, store)
    batch = keep_batch(what, larger, store)
    assert batch.ran == 11
    assert batch.table.tobytes() == Trials.of(results(what, larger)).table.tobytes()
    assert kept(store, what, larger).table.tobytes() == batch.table.tobytes()


def test_anew_all_is_run_and_takes_the_place_of_what_was_there(store: MlflowTracker) -> None:
    what = setup(rho=0.14)
    keep_batch(what, SEEDS, store)
    (before,) = runs_of(store, what)
    assert keep_batch(what, SEEDS, store, resume=False).ran == 10
    (after,) = runs_of(store, what)
    assert after.info.run_id != before.info.run_id


def test_what_a_killed_process_kept_is_resumed_and_its_run_closed(store: MlflowTracker) -> None:
    what = setup(rho=0.15)
    code = f"""
import os, signal
from acoexp import Grid
from acoexp.seeds import parse_seeds
from acoexp.settings import resolve
from acoexp.trial.solver import Solver
from acoexp.tracking import Setup
from acoexp.tracking.mlflow_tracker import MlflowTracker
from acoexp.tracking.run import RunWriter
from acoexp.trials import Trials
grid = Grid({YARD.obstacles.astype(int).tolist()}, name="yard")
what = Setup.of(resolve("aco", {{"iterations": 4, "ants": 2, "rho": 0.15}}), grid)
run = MlflowTracker({store.store.uri!r}).begin(what, parse_seeds("0-9"))
run.keep(Trials.of(Solver(what.grid, what.settings).solve_many(range(6))))
os.kill(os.getpid(), signal.SIGKILL)
"""
    ended = subprocess.run([sys.executable, "-c", code], env=environment(), timeout=120)
    assert ended.returncode == -9
    (left,) = runs_of(store, what)
    assert left.info.status == "RUNNING"
    store.prepare()
    (left,) = runs_of(store, what)
    assert (left.info.status, left.data.tags["reason"]) == (
        "FAILED",
        "left behind by a process that was killed",
    )
    batch = keep_batch(what, SEEDS, store)
    assert batch.ran == 4
    assert batch.table.tobytes() == Trials.of(results(what)).table.tobytes()


def test_a_run_that_a_living_process_writes_is_left_alone(store: MlflowTracker) -> None:
    what = setup(rho=0.16)
    log = store.begin(what, SEEDS)
    store.prepare()
    assert [run.info.status for run in runs_of(store, what)] == ["RUNNING"]
    log.abandon("enough")
    assert [run.info.status for run in runs_of(store, what)] == ["FAILED"]


@pytest.mark.parametrize(("silent_for", "status"), [(599.0, "RUNNING"), (601.0, "FAILED")])
def test_a_run_of_another_machine_is_closed_after_ten_minutes_of_silence(
    store: MlflowTracker, silent_for: float, status: str
) -> None:
    what = setup(rho=0.17, alpha=silent_for / 1000.0)
    store.begin(what, SEEDS)
    (run,) = runs_of(store, what)
    client = store.store.client
    client.set_tag(run.info.run_id, "owner", "another-host boot space 1 1.00")
    client.set_tag(run.info.run_id, "alive", str(int((time.time() - silent_for) * 1000)))
    store.prepare()
    assert [run.info.status for run in runs_of(store, what)] == [status]


def test_a_portion_that_was_cut_off_is_left_out(store: MlflowTracker, tmp_path: Path) -> None:
    what = setup(rho=0.18)
    log = store.begin(what, SEEDS)
    log.keep(Trials.of(results(what)[:5]))
    (run,) = runs_of(store, what)
    damaged = tmp_path / "00001.npz"
    damaged.write_bytes(Trials.of(results(what)[5:]).to_bytes()[:-30])
    store.store.client.log_artifact(run.info.run_id, str(damaged), "trials")
    assert kept(store, what).seeds.tolist() == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
@pytest.mark.parametrize("anew", [(False, False), (True, False), (False, True), (True, True)])
def test_of_two_that_ran_the_same_at_once_one_finished_run_stays(
    store: MlflowTracker, order: tuple[int, int], anew: tuple[bool, bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    what = setup(rho=0.19, q=1.0 + order[0] + 2 * anew[0] + 4 * anew[1])
    trials = Trials.of(results(what))
    summary = aggregate(trials.table, YARD.optimum, 4)
    logs = [MlflowTracker(store.store.uri).begin(what, SEEDS, anew=new) for new in anew]
    settling: list[Callable[[], None]] = []
    with monkeypatch.context() as late:  # both are finished before either looks for the other
        late.setattr(
            RunWriter, "_keep_only_this", lambda self, run_id: settling.append(partial(SETTLE, self, run_id))
        )
        for number in order:
            logs[number].keep(trials)
            logs[number].finish(summary, trials.curves.mean(axis=0), csv_lines(trials.table), {})
    assert [run.info.status for run in runs_of(store, what)] == ["FINISHED"] * 2
    for settle in settling:
        settle()
    assert [run.info.status for run in runs_of(store, what)] == ["FINISHED"]
    assert kept(store, what).table.tobytes() == trials.table.tobytes()


def test_two_finished_runs_of_one_identity_become_one_when_they_are_found(
    store: MlflowTracker, monkeypatch: pytest.MonkeyPatch
) -> None:
    what = setup(rho=0.25)
    with monkeypatch.context() as killed:  # right after it was finished
        killed.setattr(RunWriter, "_keep_only_this", lambda self, run_id: None)
        for _ in range(2):
            keep_batch(what, SEEDS, store, resume=False)
    assert len(runs_of(store, what)) == 2
    assert store.find(what.configuration_id).keys() == {what.identity(SEEDS)}
    assert len(runs_of(store, what)) == 1


def test_a_trial_and_a_batch_of_one_seed_are_two_things(store: MlflowTracker) -> None:
    what = setup(rho=0.26)
    store.log(Trial(what, results(what)[5]))
    assert keep_batch(what, parse_seeds("5"), store).ran == 1
    assert len(store.find(what.configuration_id)) == 2


def test_a_store_that_stays_away_ends_it_in_one_error(
    store: MlflowTracker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("acoexp.tracking.mlflow.store.PATIENCE", 0.5)
    monkeypatch.setattr(store.store, "_is_gone", False)

    def away(*_: Any, **__: Any) -> None:
        raise ConnectionError("no route")

    monkeypatch.setattr(store.store.client, "list_artifacts", away)
    what = setup(rho=0.27)
    store.begin(what, SEEDS)
    with pytest.raises(StoreGoneError, match="cannot be read for 0 s: no route"):
        keep_batch(what, SEEDS, store)
    assert {run.info.status for run in runs_of(store, what)} == {"RUNNING", "FAILED"}


def test_the_same_trial_is_kept_once(store: MlflowTracker) -> None:
    what = setup(rho=0.21)
    (result,) = solve_many(YARD, "aco", [0], iterations=4, ants=2, rho=0.21)
    for _ in range(2):
        store.log(Trial(what, result))
    (run,) = runs_of(store, what)
    assert store.find(what.configuration_id).keys() == {what.identity(0)}
    store.log(Trial(what, result), resume=False)
    (newer,) = runs_of(store, what)
    assert newer.info.run_id != run.info.run_id


def test_a_trial_that_failed_is_kept_with_its_reason_and_not_found(store: MlflowTracker) -> None:
    what = setup(rho=0.22)
    store.log_failure(what, 3, "the part broke")
    (run,) = runs_of(store, what)
    assert (run.info.status, run.data.tags["reason"], run.data.params["seed"]) == ("FAILED", "the part broke", "3")
    assert store.find(what.configuration_id) == {}


def test_a_batch_with_trials_that_failed_has_failed_and_keeps_the_others(
    store: MlflowTracker, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def trial(self: Solver, workspace: Any, seed: int, run: Any = Solver._trial) -> Result:
        if seed == 4:
            raise StrategyError("the part broke")
        result: Result = run(self, workspace, seed)
        return result

    what = setup(rho=0.23)
    with monkeypatch.context() as broken:
        broken.setattr(Solver, "_trial", trial)
        batch = keep_batch(what, SEEDS, store)
    assert [failure.seed for failure in batch.failures] == [4]
    (run,) = runs_of(store, what)
    assert (run.info.status, run.data.metrics["failed"]) == ("FAILED", 1.0)
    said = store.store.client.download_artifacts(run.info.run_id, "failed.txt", str(tmp_path))
    assert Path(said).read_text("utf-8") == "4: the part broke\n"
    assert keep_batch(what, SEEDS, store).ran == 1  # once it is mended


def test_a_list_of_seeds_too_long_for_a_parameter_is_resumed_all_the_same(store: MlflowTracker) -> None:
    what, many = setup(rho=0.24), parse_seeds(",".join(str(2 * n) for n in range(200)))
    keep_batch(what, many, store)
    assert keep_batch(what, many, store).ran == 0
