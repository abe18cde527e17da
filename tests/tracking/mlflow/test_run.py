"""One run in the store: written piece by piece, and in the end the only finished one of its identity."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from mlflow.entities import Metric, Run

from acoexp.errors import TrackingError
from acoexp.tracking.mlflow.owner import this_process
from acoexp.tracking.mlflow.run import RunWriter, is_whole, mark_failed
from acoexp.tracking.mlflow.store import Store

CELL = "0123456789abcdef"
"""The identity of a configuration."""
TRIAL = [Metric("optimum", 7.0, 1, 0), Metric("lost_ants", 0.0, 1, 0)]
"""What every finished trial has."""


def writer(store: Store, identity: str, replace: bool = False, **params: str) -> RunWriter:
    """Return a run that has begun."""
    made = RunWriter(store, "mine", params, {"identity": identity, "kind": "trial", "cell": CELL}, replace=replace)
    made.begin(TRIAL)
    return made


def runs(store: Store, identity: str) -> list[Run]:
    """Return the runs of an identity."""
    return store.search(f"tags.identity = '{identity}'")


def statuses(store: Store, identity: str) -> list[str]:
    """Return the states of the runs of an identity."""
    return [run.info.status for run in runs(store, identity)]


# --- written piece by piece


def test_a_run_says_from_its_beginning_what_it_is_and_who_writes_it(store: Store, identity: str) -> None:
    RunWriter(store, "mine", {"rho": "0.5"}, {"identity": identity}, started=1234).begin([Metric("l1", 7.0, 1, 0)])
    (run,) = runs(store, identity)
    assert (run.info.status, run.info.run_name, run.info.start_time) == ("RUNNING", "mine", 1234)
    assert (run.data.params, run.data.metrics) == ({"rho": "0.5"}, {"l1": 7.0})
    assert run.data.tags["owner"] == this_process()
    assert int(run.data.tags["alive"]) > 1234


def test_a_sign_of_life_is_newer_than_the_one_before(
    store: Store, identity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = writer(store, identity)
    before = int(runs(store, identity)[0].data.tags["alive"])
    monkeypatch.setattr("acoexp.tracking.mlflow.run._now", lambda: str(before + 5))
    run.heartbeat()
    assert runs(store, identity)[0].data.tags["alive"] == str(before + 5)


@pytest.mark.parametrize(("characters", "kept_as_param"), [(500, True), (501, False), (9000, False)])
def test_a_param_too_long_for_mlflow_becomes_an_artifact(
    store: Store, identity: str, characters: int, kept_as_param: bool, tmp_path: Path
) -> None:
    text = "ä" + "x" * (characters - 1)
    writer(store, identity, **{"map.name": "file", "map.path": text})
    (run,) = runs(store, identity)
    assert run.data.params["map.name"] == "file"
    if kept_as_param:
        assert run.data.params["map.path"] == text
    else:
        assert "map.path" not in run.data.params
        file = store.client.download_artifacts(run.info.run_id, "params/map.path.txt", str(tmp_path))
        assert Path(file).read_text(encoding="utf-8") == text


@pytest.mark.parametrize("when", ["begin", "log_metrics"])
def test_more_metrics_than_mlflow_takes_at_once_all_arrive(store: Store, identity: str, when: str) -> None:
    points = [Metric("best_length", float(step), 1, step) for step in range(2345)]
    made = RunWriter(store, "mine", {}, {"identity": identity})
    made.begin(points if when == "begin" else ())
    made.log_metrics(points if when == "log_metrics" else ())
    history = store.client.get_metric_history(runs(store, identity)[0].info.run_id, "best_length")
    assert sorted((point.step, point.value) for point in history) == [(step, float(step)) for step in range(2345)]


def test_a_file_is_kept_in_its_folder(store: Store, identity: str, tmp_path: Path) -> None:
    (tmp_path / "x.npz").write_bytes(b"x")
    writer(store, identity).log_file(tmp_path / "x.npz", "trials")
    run_id = runs(store, identity)[0].info.run_id
    assert [each.path for each in store.client.list_artifacts(run_id, "trials")] == ["trials/x.npz"]


# --- its end


def test_a_run_that_failed_says_why(store: Store, identity: str) -> None:
    writer(store, identity).fail("the part broke")
    (run,) = runs(store, identity)
    assert (run.info.status, run.data.tags["reason"]) == ("FAILED", "the part broke")


def test_a_reason_longer_than_a_tag_is_cut(store: Store, identity: str) -> None:
    writer(store, identity).fail("the part broke: " + "x" * 20_000)
    (run,) = runs(store, identity)
    assert run.data.tags["reason"] == "the part broke: " + "x" * 4980 + " ..."


def test_a_reason_has_no_password(store: Store, identity: str) -> None:
    writer(store, identity).fail("cannot reach http://me:s3cret@host/")
    assert runs(store, identity)[0].data.tags["reason"] == "cannot reach http://***@host/"


def test_a_hasty_end_marks_what_is_not_finished(store: Store, identity: str) -> None:
    begun, finished = writer(store, identity), writer(store, f"{identity}, finished")
    RunWriter(store, "mine", {}, {"identity": f"{identity}, not begun"}).abort("enough")
    finished.finish()
    for run in (begun, finished):
        run.abort("enough")
    assert statuses(store, identity) == ["FAILED"]
    assert statuses(store, f"{identity}, finished") == ["FINISHED"]
    assert statuses(store, f"{identity}, not begun") == []


def test_a_hasty_end_does_not_fail_where_the_store_is_gone(
    store: Store, identity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def away(*_: Any) -> None:
        raise ConnectionError("no route")

    run = writer(store, identity)
    with monkeypatch.context() as gone:
        gone.setattr(store.client, "set_terminated", away)
        run.abort("enough")
    assert statuses(store, identity) == ["RUNNING"]


def test_a_run_that_was_taken_for_left_behind_and_ends_well_has_not_failed(store: Store, identity: str) -> None:
    run = writer(store, identity)
    mark_failed(store, runs(store, identity)[0].info.run_id, "left behind")
    run.finish()
    (found,) = runs(store, identity)
    assert found.info.status == "FINISHED"
    assert "reason" not in found.data.tags


def test_a_run_that_was_made_twice_as_an_answer_was_lost_is_one_in_the_end(
    store: Store, identity: str, pauses: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    create, lost = store.client.create_run, [ConnectionError("reset")]

    def create_and_lose(*args: Any) -> Run:
        made = create(*args)
        if lost:
            raise lost.pop()
        return made

    monkeypatch.setattr(store.client, "create_run", create_and_lose)
    run = writer(store, identity)
    assert statuses(store, identity) == ["RUNNING"] * 2
    run.finish()
    assert statuses(store, identity) == ["FINISHED"]


# --- alone of its identity


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
@pytest.mark.parametrize("replaces", [(False, False), (True, False), (False, True), (True, True)])
def test_of_two_that_ran_the_same_at_once_one_finished_run_stays(
    store: Store,
    identity: str,
    order: tuple[int, int],
    replaces: tuple[bool, bool],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    written = [writer(store, identity, replace) for replace in replaces]
    looking: list[Callable[[], None]] = []
    with monkeypatch.context() as late:  # both are finished before either looks for the other
        late.setattr(RunWriter, "_keep_only_this", lambda self, run_id: looking.append((self, run_id)))
        for number in order:
            written[number].finish()
    assert statuses(store, identity) == ["FINISHED"] * 2
    for run, run_id in looking:
        run._keep_only_this(run_id)
    assert statuses(store, identity) == ["FINISHED"]


def test_runs_of_other_identities_and_of_others_that_are_at_work_stay(store: Store, identity: str) -> None:
    other, working = writer(store, f"{identity}, too"), writer(store, identity)
    other.finish()
    writer(store, identity).finish()
    assert sorted(statuses(store, identity)) == ["FINISHED", "RUNNING"]
    assert statuses(store, f"{identity}, too") == ["FINISHED"]
    working.abort("enough")


def test_a_run_that_a_person_edited_stays_beside_the_one_that_was_run_in_its_place(
    store: Store, identity: str
) -> None:
    writer(store, identity).finish()
    (edited,) = runs(store, identity)
    store.client.set_tag(edited.info.run_id, "kind", "mine")
    writer(store, identity).finish()
    assert statuses(store, identity) == ["FINISHED"] * 2
    assert [is_whole(run) for run in runs(store, identity)] == [False, True]


def test_what_the_store_does_not_take_is_told(
    store: Store, identity: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: Any) -> None:
        raise RuntimeError("disk full\nand more")

    monkeypatch.setattr(store.client, "log_batch", full)
    with pytest.raises(TrackingError, match=r"does not take a trial: disk full$"):
        writer(store, identity)
