"""Runs that were left behind are closed; those that are written, and whatever a person keeps, are left alone."""

from __future__ import annotations

import time
from typing import Any

import pytest
from mlflow.entities import Run

from acoexp.tracking.mlflow import left_behind
from acoexp.tracking.mlflow.left_behind import close_left_behind
from acoexp.tracking.mlflow.run import RunWriter
from acoexp.tracking.mlflow.store import Store

ELSEWHERE = "another-host boot space 1 1.00"
"""The mark of a process of another machine."""


def begun(store: Store, identity: str, **tags: str) -> Run:
    """Return a run that has begun, with some of its tags written over by a person."""
    RunWriter(store, "mine", {}, {"identity": identity, "kind": "batch"}).begin()
    (run,) = store.search(f"tags.identity = '{identity}'")
    for key, value in tags.items():
        store.client.set_tag(run.info.run_id, key, value)
    return run


def status(store: Store, run: Run) -> str:
    """Return a run's state."""
    return str(store.client.get_run(run.info.run_id).info.status)


def ago(seconds: float) -> str:
    """Return a moment of the past as runs have it."""
    return str(int((time.time() - seconds) * 1000))


def test_a_run_that_a_living_process_writes_is_left_alone(store: Store, identity: str) -> None:
    run = begun(store, identity)
    close_left_behind(store)
    assert status(store, run) == "RUNNING"


def test_a_run_whose_process_is_gone_is_closed(
    store: Store, identity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = begun(store, identity)
    monkeypatch.setattr(left_behind, "is_dead", lambda mark: True)
    close_left_behind(store)
    closed = store.client.get_run(run.info.run_id)
    said = (closed.info.status, closed.data.tags["reason"])
    assert said == ("FAILED", "left behind by a process that was killed")


@pytest.mark.parametrize(("silent_for", "expected"), [(590.0, "RUNNING"), (610.0, "FAILED")])
def test_a_run_of_another_machine_is_closed_after_ten_minutes_of_silence(
    store: Store, identity: str, silent_for: float, expected: str
) -> None:
    run = begun(store, identity, owner=ELSEWHERE, alive=ago(silent_for))
    close_left_behind(store)
    assert status(store, run) == expected


@pytest.mark.parametrize("alive", ["", "yes", "nan", "-inf"])
def test_a_sign_of_life_that_a_person_wrote_over_blocks_nothing(store: Store, identity: str, alive: str) -> None:
    run = begun(store, identity, owner=ELSEWHERE, alive=alive)
    close_left_behind(store)
    assert status(store, run) in ("RUNNING", "FAILED")


@pytest.mark.parametrize("owner", ["alice", "", "alice 1", "a b c", "a 1 b", "a -1 1.0", f"a {'9' * 30} 1.0"])
def test_a_run_that_a_person_made_theirs_is_left_alone(store: Store, identity: str, owner: str) -> None:
    run = begun(store, identity, owner=owner, alive=ago(10_000.0))
    close_left_behind(store)
    assert status(store, run) == "RUNNING"


@pytest.mark.parametrize("missing", ["owner", "writer", "identity"])
def test_a_run_that_lacks_what_ours_have_is_left_alone(store: Store, identity: str, missing: str) -> None:
    run = begun(store, identity, owner=ELSEWHERE, alive=ago(10_000.0))
    store.client.delete_tag(run.info.run_id, missing)
    close_left_behind(store)
    assert status(store, run) == "RUNNING"


def test_a_run_that_another_program_keeps_in_the_experiment_is_left_alone(store: Store) -> None:
    run = store.client.create_run(store.experiment_id, tags={"owner": "alice"})
    close_left_behind(store)
    assert status(store, run) == "RUNNING"


def test_a_run_that_is_deleted_meanwhile_blocks_nothing(
    store: Store, identity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = begun(store, identity, owner=ELSEWHERE, alive=ago(10_000.0))
    get = store.client.get_run

    def get_and_delete(run_id: str) -> Any:
        found = get(run_id)
        if run_id == run.info.run_id:
            store.client.delete_run(run_id)
        return found

    with monkeypatch.context() as meanwhile:
        meanwhile.setattr(store.client, "get_run", get_and_delete)
        close_left_behind(store)
    assert store.client.get_run(run.info.run_id).info.lifecycle_stage == "deleted"
