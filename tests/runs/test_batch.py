"""A batch that is kept: what the store has of it is taken from there, the rest is run, and all is one run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit
from urllib.request import url2pathname

import pytest
from forked import forking
from mlflow.entities import Run

from acoexp import Grid
from acoexp.errors import StoreGoneError, StrategyError
from acoexp.registry.resolve import resolve
from acoexp.runs.batch import keep_batch, kept_trials
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup, Trial
from acoexp.tracking.tracker import NoTracker
from acoexp.trial.result import Result
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SEEDS = parse_seeds("0-9")


def setup(**settings: Any) -> Setup:
    """Return a setup of quick trials."""
    return Setup.of(resolve("aco", {"iterations": 4, "ants": 2, **settings}), YARD)


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
    history = client.get_metric_history(run.info.run_id, "cycle_length")
    assert {point.step: point.value for point in history} == dict(enumerate(batch.curve.tolist(), 1))
    assert kept(store, what).table.tobytes() == batch.table.tobytes() == Trials.of(one_by_one).table.tobytes()


def test_the_same_batch_again_runs_nothing(store: MlflowTracker) -> None:
    what = setup(rho=0.12)
    first = keep_batch(what, SEEDS, store)
    again = keep_batch(what, SEEDS, store)
    assert (first.ran, again.ran) == (10, 0)
    assert again.table.tobytes() == first.table.tobytes()
    assert len(runs_of(store, what)) == 1


@pytest.mark.parametrize("lost", [Path.unlink, lambda file: file.write_bytes(b"PK")], ids=["gone", "damaged"])
def test_a_finished_batch_whose_trials_are_lost_is_run_and_kept_again(
    lost: Callable[[Path], object], store: MlflowTracker
) -> None:
    what = setup(rho=0.121)
    keep_batch(what, parse_seeds("0-4"), store)
    keep_batch(what, SEEDS, store)
    for run in runs_of(store, what):
        for file in Path(url2pathname(urlsplit(run.info.artifact_uri).path), "trials").glob("*.npz"):
            lost(file)
    first, again, third = (keep_batch(what, SEEDS, store) for _ in range(3))
    assert (first.ran, again.ran, third.ran) == (10, 0, 0)
    assert again.table.tobytes() == Trials.of(results(what)).table.tobytes()
    finished = [run.data.params["seeds"] for run in runs_of(store, what) if run.info.status == "FINISHED"]
    assert sorted(finished) == ["0-4", "0-9"]


def test_a_larger_batch_runs_what_is_missing(store: MlflowTracker) -> None:
    what, larger = setup(rho=0.13), parse_seeds("5-19,30")
    keep_batch(what, SEEDS, store)
    batch = keep_batch(what, larger, store)
    assert batch.ran == 11
    assert batch.table.tobytes() == Trials.of(results(what, larger)).table.tobytes()
    assert kept(store, what, larger).table.tobytes() == batch.table.tobytes()


def test_without_resuming_all_is_run_and_takes_the_place_of_what_was_there(store: MlflowTracker) -> None:
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
from acoexp.registry.resolve import resolve
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Setup
from acoexp.trial.seeds import parse_seeds
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials
grid = Grid({YARD.obstacles.astype(int).tolist()}, name="yard")
what = Setup.of(resolve("aco", {{"iterations": 4, "ants": 2, "rho": 0.15}}), grid)
run = MlflowTracker({store.store.uri!r}).begin(what, parse_seeds("0-9"))
run.keep(Trials.of(Solver(what.grid, what.settings).solve_many(range(6))))
os.kill(os.getpid(), signal.SIGKILL)
"""
    context = forking()
    killed = context.Process(target=exec, args=(code,))
    killed.start()
    killed.join(timeout=120.0)
    assert killed.exitcode == -9
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


def test_a_trial_and_a_batch_of_one_seed_are_two_things(store: MlflowTracker) -> None:
    what = setup(rho=0.26)
    store.log(Trial(what, results(what)[5]))
    assert keep_batch(what, parse_seeds("5"), store).ran == 1
    found = store.find(what.configuration_id, {what.identity(5), what.identity(parse_seeds("5"))})
    assert sorted(run.kind for run in found.values()) == ["batch", "trial"]


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


def test_portions_are_handed_on_whether_they_were_found_or_run(store: MlflowTracker) -> None:
    what = setup(rho=0.28)
    keep_batch(what, parse_seeds("0-3"), store)
    portions: list[Trials] = []
    shown: list[int] = []
    batch = keep_batch(what, SEEDS, store, receive=portions.append, show=shown.append)
    assert [portion.seeds.tolist() for portion in portions] == [[0, 1, 2, 3], [4, 5, 6, 7, 8, 9]]
    assert (batch.ran, shown[-1]) == (6, 10)


def test_what_was_found_is_told_once(store: MlflowTracker, caplog: pytest.LogCaptureFixture) -> None:
    what = setup(rho=0.29)
    caplog.set_level("INFO")
    keep_batch(what, parse_seeds("0-3"), store)
    assert caplog.messages == []
    keep_batch(what, SEEDS, store)
    assert caplog.messages == ["aco on yard: 4 of 10 trials found in the store"]


def test_a_batch_that_ends_early_says_why(store: MlflowTracker) -> None:
    def interrupted(portion: Trials) -> None:
        raise KeyboardInterrupt

    what = setup(rho=0.31)
    with pytest.raises(KeyboardInterrupt):
        keep_batch(what, SEEDS, store, receive=interrupted)
    (run,) = runs_of(store, what)
    assert (run.info.status, run.data.tags["reason"]) == ("FAILED", "KeyboardInterrupt")
    assert kept(store, what).table.tobytes() == Trials.of(results(what)).table.tobytes()


def test_the_trials_of_a_batch_are_to_be_had_in_the_order_of_their_seeds(store: MlflowTracker) -> None:
    what = setup(rho=0.32)
    keep_batch(what, parse_seeds("5-9"), store)
    trials = kept_trials(what.settings, YARD, SEEDS, tracker=store)
    assert trials.table.tobytes() == Trials.of(results(what)).table.tobytes()


def test_the_trials_of_a_batch_in_which_one_failed_are_not_to_be_had(monkeypatch: pytest.MonkeyPatch) -> None:
    def trial(self: Solver, workspace: Any, seed: int, run: Any = Solver._trial) -> Result:
        if seed == 4:
            raise StrategyError("the part broke")
        result: Result = run(self, workspace, seed)
        return result

    monkeypatch.setattr(Solver, "_trial", trial)
    with pytest.raises(StrategyError, match="the part broke"):
        kept_trials(setup(rho=0.33).settings, YARD, SEEDS, tracker=NoTracker())
