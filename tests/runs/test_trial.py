"""One trial that is kept: found again if it came to a result, told of if it did not."""

from __future__ import annotations

import time
from typing import Any

import pytest

from acoexp import Grid, Result, solve
from acoexp.errors import StrategyError, TrackingError
from acoexp.registry.resolve import resolve
from acoexp.runs.trial import keep_trial
from acoexp.tracking.mlflow.tracker import MlflowTracker
from acoexp.tracking.setup import Artifacts, Setup, Trial
from acoexp.tracking.tracker import NoTracker
from acoexp.trial.solver import Solver

YARD = Grid([[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]], name="yard")
SETTINGS: dict[str, Any] = {"iterations": 4, "ants": 2, "rho": 0.91}
WHAT = Setup.of(resolve("aco", SETTINGS), YARD)


class Noting(NoTracker):
    """Notes what it is given."""

    def __init__(self) -> None:
        self.kept: list[tuple[Trial, bool]] = []
        self.failed: list[tuple[int, str]] = []

    def log(self, trial: Trial, *, resume: bool = True) -> None:
        self.kept.append((trial, resume))

    def log_failure(self, setup: Setup, seed: int, reason: str) -> None:
        self.failed.append((seed, reason))


def test_a_trial_that_was_kept_is_found_again_with_what_python_finds(store: MlflowTracker) -> None:
    kept = keep_trial(WHAT, 3, store)
    (found,) = store.find(WHAT.configuration_id, {kept.identity}).values()
    result = solve(YARD, "aco", 3, **SETTINGS)
    assert kept.result.as_dict() == result.as_dict()
    assert (found.kind, found.metrics["l1"]) == ("trial", result.l1)
    assert store.has(kept.identity)


@pytest.mark.parametrize("resume", [True, False])
def test_the_tracker_is_told_whether_what_it_has_of_the_same_trial_stays(resume: bool) -> None:
    tracker = Noting()
    kept = keep_trial(WHAT, 3, tracker, resume=resume)
    assert tracker.kept == [(kept, resume)]


def test_if_nothing_is_said_it_stays() -> None:
    tracker = Noting()
    keep_trial(WHAT, 3, tracker)
    assert [resume for _, resume in tracker.kept] == [True]


def test_the_time_that_it_took_is_that_of_the_trial_alone() -> None:
    began = time.perf_counter()
    kept = keep_trial(WHAT, 3, NoTracker())
    assert 0.0 < kept.seconds < time.perf_counter() - began


def test_it_is_shown_before_anything_is_made_of_it_and_the_tracker_is_ready_then() -> None:
    done: list[str] = []

    class Ordered(Noting):
        def log(self, trial: Trial, *, resume: bool = True) -> None:
            done.append(f"kept with {[*trial.artifacts]}")

    def artifacts(result: Result) -> Artifacts:
        done.append("drawn")
        return {"path.csv": b""}

    def show(trial: Trial) -> None:
        done.append(f"shown with {[*trial.artifacts]}")

    keep_trial(WHAT, 3, Ordered(), show=show, artifacts=artifacts, ready=lambda: done.append("ready"))
    assert done == ["shown with []", "drawn", "ready", "kept with ['path.csv']"]


@pytest.mark.parametrize("where", ["solve", "__init__"])
def test_a_trial_that_failed_is_kept_with_its_reason_and_raised(
    where: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any) -> None:
        raise StrategyError("the part broke")

    monkeypatch.setattr(Solver, where, fail)
    tracker = Noting()
    ready: list[int] = []
    with pytest.raises(StrategyError, match=r"^the part broke$"):
        keep_trial(WHAT, 3, tracker, ready=lambda: ready.append(len(tracker.failed)))
    assert (tracker.kept, tracker.failed, ready) == ([], [(3, "the part broke")], [0])


def test_a_trial_that_the_store_does_not_take_has_not_failed() -> None:
    class Full(Noting):
        def log(self, trial: Trial, *, resume: bool = True) -> None:
            raise TrackingError("disk full")

    tracker = Full()
    with pytest.raises(TrackingError, match="disk full"):
        keep_trial(WHAT, 3, tracker)
    assert tracker.failed == []
