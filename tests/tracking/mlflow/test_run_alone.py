"""Of the finished runs of one identity one stays, whoever looks; one that a person edited is none of them."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from mlflow.exceptions import MlflowException
from mlflow.protos.databricks_pb2 import INVALID_PARAMETER_VALUE, PERMISSION_DENIED

from acoexp.tracking.mlflow.run import RunWriter, is_whole, keep_one
from acoexp.tracking.mlflow.store import Store


def finished(run_id: str, began: int, replaces: str | None = None, **metrics: float) -> Any:
    """Return a finished run as the store has it."""
    tags = {"kind": "batch", "cell": "0123456789abcdef", **({} if replaces is None else {"anew": replaces})}
    info = SimpleNamespace(run_id=run_id, start_time=began, status="FINISHED")
    return SimpleNamespace(info=info, data=SimpleNamespace(tags=tags, metrics=metrics))


class Deleting:
    """A store that notes what is deleted, or refuses it."""

    def __init__(self, problem: Exception | None = None) -> None:
        self.client, self.deleted, self.problem = self, [], problem

    def delete_run(self, run_id: str) -> None:
        self.deleted.append(run_id)
        if self.problem is not None:
            raise self.problem


@pytest.mark.parametrize(
    ("same", "stays"),
    [
        ([finished("a", 1)], "a"),
        ([finished("a", 2), finished("b", 1)], "b"),
        ([finished("a", 1), finished("b", 1)], "b"),
        ([finished("a", 1), finished("b", 3, "3000"), finished("c", 2, "2000")], "b"),
    ],
    ids=["one", "the oldest", "any, but all agree", "the newest that replaces"],
)
def test_all_who_look_leave_the_same_run(same: list[Any], stays: str) -> None:
    for seen in (same, same[::-1]):
        store: Any = Deleting()
        assert keep_one(store, seen).info.run_id == stays
        assert sorted(store.deleted) == sorted(run.info.run_id for run in same if run.info.run_id != stays)


def test_a_run_that_another_process_has_deleted_already_is_gone_all_the_same() -> None:
    both = [finished("a", 1), finished("b", 2)]
    store: Any = Deleting(MlflowException("no such run", INVALID_PARAMETER_VALUE))
    assert keep_one(store, both).info.run_id == "a"
    refusing: Any = Deleting(MlflowException("not yours", PERMISSION_DENIED))
    with pytest.raises(MlflowException, match="not yours"):
        keep_one(refusing, both)


def begun(address: str) -> tuple[Store, RunWriter]:
    """Return a store, and a run in it that is being written."""
    store = Store(address)
    store.prepare()
    writer = RunWriter(store, "mine", {}, {"identity": "one", "kind": "trial", "cell": "0" * 16})
    writer.begin()
    return store, writer


def test_a_run_is_finished_also_where_a_person_renames_its_experiment(fresh: str) -> None:
    store, writer = begun(fresh)
    store.client.rename_experiment(store.experiment_id, "another")
    writer.finish()
    (run,) = store.client.search_runs([store.experiment_id])
    assert run.info.status == "FINISHED"


def test_a_run_that_a_person_deletes_as_it_is_finished_is_no_error(fresh: str) -> None:
    store, writer = begun(fresh)
    writer.do(store.client.delete_run)
    writer.do(writer._keep_only_this)
    assert store.client.search_runs([store.experiment_id]) == []


BATCH = {"trials": 10.0, "never_arrived": 0.0, "success_rate": 0.5}
"""What every finished batch has."""


def test_a_finished_run_that_a_person_edited_is_not_taken_for_ours() -> None:
    assert is_whole(finished("a", 1, **BATCH))
    for name in BATCH:
        assert not is_whole(finished("a", 1, **{key: value for key, value in BATCH.items() if key != name}))
        for value in (math.nan, math.inf, -1.0, 1e300):
            assert not is_whole(finished("a", 1, **{**BATCH, name: value}))
    for tag in ({"kind": ""}, {"kind": "mine"}, {"cell": ""}, {"cell": "mine"}):
        edited = finished("a", 1, **BATCH)
        edited.data.tags |= tag
        assert not is_whole(edited)
