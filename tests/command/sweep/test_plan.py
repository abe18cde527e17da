"""The plan of a sweep: its jobs in order, each checked before any runs, and those left out that need not run."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any

import pytest
from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.types import RunMode
from omegaconf import DictConfig
from omegaconf.errors import InterpolationKeyError

from acoexp.command.handover import Handover
from acoexp.command.sweep.plan import Plan
from acoexp.errors import SettingsError
from acoexp.tracking.setup import Found
from acoexp.tracking.tracker import NoTracker

Composed = Callable[..., DictConfig]

QUICK = ("tracking=none", "iterations=3", "ants=2")


def parsed(*overrides: str) -> list[Any]:
    """Return overrides as Hydra reads them."""
    return OverridesParser.create().parse_overrides(list(overrides))


# --- the plan


class Store(NoTracker):
    """A store that has finished runs."""

    def __init__(self, where: str = "nowhere", address: str | None = None) -> None:
        self.where, self.address, self.prepared = where, address, 0
        self.runs: dict[str, dict[str, Found]] = {}

    def prepare(self) -> None:
        self.prepared += 1

    def find(self, configuration_id: str, identities: Collection[str]) -> dict[str, Found]:
        runs = self.runs.get(configuration_id, {})
        return {identity: run for identity, run in runs.items() if identity in identities}

    def has_all(self, identities: Collection[str]) -> bool:
        return {identity for runs in self.runs.values() for identity in runs} >= {*identities}


@pytest.fixture
def planned(composed: Composed, handover: Handover) -> Callable[..., Plan]:
    """Return what makes the plan of a sweep from overrides."""

    def plan(*overrides: str) -> Plan:
        config = composed(*(text for text in overrides if text.startswith("hydra.")), mode=RunMode.MULTIRUN)
        loader = GlobalHydra.instance().config_loader()
        sources = list(loader.get_sources())
        try:
            return Plan(config, loader, parsed(*(text for text in overrides if not text.startswith("hydra."))))
        finally:
            loader.get_sources()[:] = sources  # it made them remember

    return plan


def test_a_configuration_is_checked_once_whatever_its_seeds(planned: Callable[..., Plan]) -> None:
    plan = planned("algo=aco,pd", "seed=0,1,2", *QUICK)
    assert [job.config["algo"] for job in plan.jobs.values()] == ["aco", "pd"]
    assert plan.has_reports is False
    assert plan.where == "not tracked"


@pytest.mark.parametrize("others", [(), ("map=random", "map.seed=${seed}")])
def test_a_seed_may_be_told_by_another_sign(others: tuple[str, ...], planned: Callable[..., Plan]) -> None:
    left = planned(*others, "++seed=3,4", *QUICK).leave_out_known()
    assert (left.trials, left.repeated, len(left.missing)) == (2, 0, 2)


def test_a_seed_is_told_once(planned: Callable[..., Plan]) -> None:
    with pytest.raises(SettingsError, match=r"^seed: expected to be told once; got seed and \+\+seed$"):
        planned("seed=0,1", "++seed=5", *QUICK)


def test_seeds_share_a_job_where_a_reference_is_to_something_else(planned: Callable[..., Plan]) -> None:
    plan = planned("ants=7", "iterations=${ants}", "tracking=none", "seed=3,4")
    assert len({id(job) for job in plan.jobs.values()}) == 1


def test_where_something_else_is_the_seeds_each_is_checked_for_itself(planned: Callable[..., Plan]) -> None:
    plan = planned("map=random", "map.seed=${seed}", "seed=3,4", *QUICK)
    assert [job.setup.map["seed"] for job in plan.jobs.values()] == [3, 4]
    assert len({job.setup.configuration_id for job in plan.jobs.values()}) == 2
    assert [told[2] for told in plan.leave_out_known().missing] == ["seed=3", "seed=4"]


@pytest.mark.parametrize(
    ("overrides", "said"),
    [
        (["rho=0.3,1.5"], "rho: expected a number from 0 to 1; got 1.5"),
        (["seed=1,x"], "seed: expected a whole number from 0 to 2^64 - 1; got 'x'"),
        (["seed=1,01"], "seed: expected a whole number from 0 to 2^64 - 1; got '01'"),
        (["seed=1,-1"], "seed: expected a whole number from 0 to 2^64 - 1; got '-1'"),
    ],
)
def test_one_job_that_is_wrong_stops_all(planned: Callable[..., Plan], overrides: list[str], said: str) -> None:
    with pytest.raises(SettingsError) as caught:
        planned(*overrides, *QUICK)
    assert str(caught.value) == said


@pytest.mark.parametrize("overrides", [["algo=aco"], ["algo=pd,aco"]])
def test_a_name_of_a_folder_that_refers_to_what_a_job_lacks_stops_all(
    planned: Callable[..., Plan], overrides: list[str]
) -> None:
    named = "hydra.sweep.subdir=${diffusion.gamma}_${hydra.job.num}_${hydra.job.id}"
    assert planned("algo=pd", *QUICK, named).jobs
    with pytest.raises(InterpolationKeyError, match=r"'diffusion\.gamma' not found"):
        planned(*overrides, *QUICK, named)


def test_all_stores_are_made_ready_and_their_addresses_and_all_maps_handed_over(
    planned: Callable[..., Plan], handover: Handover, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    stores = {uri: Store(uri, f"/absolute/{uri}") for uri in ("x", "y")}
    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: stores[config["uri"]])
    plan = planned("tracking.uri=x,y", "map=fig13,env1")
    assert plan.where == "x, y"
    plan.prepare(tmp_path)
    assert [store.prepared for store in stores.values()] == [1, 1]
    assert handover.addresses == {"x": "/absolute/x", "y": "/absolute/y"}
    maps = [handover.map_of(job.config["map"]) for job in plan.jobs.values()]
    assert [grid.name for grid in maps if grid is not None] == ["fig13", "env1"] * 2


def test_what_the_store_has_is_left_out_and_its_record_is_there(
    planned: Callable[..., Plan], monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store()
    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: store)
    plan = planned("algo=aco,pd", "seed=0,1", *QUICK)
    setup = next(iter(plan.jobs.values())).setup
    store.runs[setup.configuration_id] = {setup.identity(seed): Found("trial", 1, {"l1": 35.0}) for seed in (1, 7)}
    left = plan.leave_out_known()
    assert [[text for text in told if text not in QUICK] for told in left.missing] == [
        ["algo=aco", "seed=0"], ["algo=pd", "seed=0"], ["algo=pd", "seed=1"],
    ]  # fmt: skip
    assert [(record["seed"], record["l1"]) for record in left.known] == [(1, 35.0)]
    assert (left.found, left.trials, left.repeated) == (1, 4, 0)


@pytest.mark.parametrize(
    ("overrides", "kept"),
    [
        (["seed=0,1"], True),
        (["seed=0,1,2"], False),
        (["algo=aco,pd", "seed=0,1"], False),
        (["seed=0,1", "resume=false"], False),
        (["report=compare", "report.trials=2"], False),
    ],
)
def test_a_quick_look_shows_whether_all_is_kept(
    overrides: list[str], kept: bool, planned: Callable[..., Plan], monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store()
    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: store)
    plan = planned("algo=aco", *overrides, *QUICK)
    setup = next(iter(plan.jobs.values())).setup
    store.runs[setup.configuration_id] = {setup.identity(seed): Found("trial", 1, {}) for seed in (0, 1)}
    assert plan.is_kept() is kept
    assert store.prepared == 0


def test_without_resuming_nothing_is_left_out(
    planned: Callable[..., Plan], monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store()
    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: store)
    plan = planned("seed=0,1", "resume=false", *QUICK)
    setup = next(iter(plan.jobs.values())).setup
    store.runs[setup.configuration_id] = {setup.identity(1): Found("trial", 1, {})}
    assert (len(plan.leave_out_known().missing), plan.leave_out_known().found) == (2, 0)


def test_a_batch_is_as_many_trials_as_it_has_seeds(
    planned: Callable[..., Plan], monkeypatch: pytest.MonkeyPatch
) -> None:
    store = Store()
    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: store)
    plan = planned("algo=aco,pd", "seeds='0-9'", *QUICK)
    job = next(iter(plan.jobs.values()))
    metrics = {"never_arrived": 0.0, "success_rate": 0.5}
    found = Found("batch", 10, metrics)
    store.runs[job.setup.configuration_id] = {job.setup.identity(job.seeds): found}
    left = plan.leave_out_known()
    assert (len(left.missing), left.found, left.trials) == (1, 10, 20)


def test_the_same_trial_in_two_stores_is_two(
    planned: Callable[..., Plan], monkeypatch: pytest.MonkeyPatch
) -> None:
    stores = {uri: Store(uri, uri) for uri in ("x", "y")}
    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: stores[config["uri"]])
    plan = planned("tracking.uri=x,y", "seed=0", *QUICK[1:])
    setup = next(iter(plan.jobs.values())).setup
    stores["x"].runs[setup.configuration_id] = {setup.identity(0): Found("trial", 1, {"l1": 35.0})}
    left = plan.leave_out_known()
    assert ([told[0] for told in left.missing], left.found, left.repeated) == (["tracking.uri=y"], 1, 0)


def test_jobs_that_say_the_same_run_once(planned: Callable[..., Plan]) -> None:
    left = planned("rho=0.5,0.50,0.6", "seed=0,1,0", *QUICK).leave_out_known()
    assert [[text for text in told if text not in QUICK] for told in left.missing] == [
        ["rho=0.5", "seed=0"], ["rho=0.5", "seed=1"], ["rho=0.6", "seed=0"], ["rho=0.6", "seed=1"],
    ]  # fmt: skip
    assert (left.trials, left.repeated) == (4, 5)


def test_reports_are_never_left_out(planned: Callable[..., Plan]) -> None:
    plan = planned("report=compare", "report.trials=2,2", "tracking=none")
    assert plan.has_reports
    assert (len(plan.leave_out_known().missing), plan.leave_out_known().repeated) == (2, 0)
