"""What Hydra runs of each job, and which jobs of a sweep share what it takes to run them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hydra.types import RunMode
from omegaconf import DictConfig

from acoexp.command.handover import Handover
from acoexp.command.job import plain
from acoexp.command.main import _job_of, run_job
from acoexp.errors import SettingsError, StoreGoneError
from acoexp.tracking.tracker import NoTracker

Composed = Callable[..., DictConfig]

QUICK = ("algo=aco", "tracking=none", "iterations=3", "ants=2")


@pytest.fixture
def sweeping(handover: Handover, tmp_path: Path) -> Handover:
    """Return the handover of a sweep."""
    handover.put_maps(tmp_path / "sweep", [])
    return handover


def test_references_are_resolved_and_hydras_own_part_is_left_out(composed: Composed) -> None:
    values = plain(composed("map=random", "map.seed=${seed}", "seed=7"))
    assert (values["seed"], values["map"]["seed"]) == (7, 7)
    assert "hydra" not in values


def test_trials_of_a_sweep_that_differ_by_their_seed_alone_share_a_setup_and_a_solver(
    composed: Composed, sweeping: Handover
) -> None:
    one, other = (_job_of(composed(*QUICK, f"seed={seed}"), sweeping) for seed in (3, 4))
    assert (one.keys.seed, one.config["seed"], other.keys.seed, other.config["seed"]) == (3, 3, 4, 4)
    assert one.setup is other.setup
    assert one._solver() is other._solver()


@pytest.mark.parametrize("others", [("rho=0.2",), ("map=random", "map.seed=${seed}")])
def test_others_do_not(others: tuple[str, ...], composed: Composed, sweeping: Handover) -> None:
    one = _job_of(composed(*QUICK, "seed=3", *others[1:], others[0]), sweeping)
    other = _job_of(composed(*QUICK, "seed=4", *(others if len(others) > 1 else ())), sweeping)
    assert one.setup.configuration_id != other.setup.configuration_id


def test_a_seed_that_is_none_is_refused_also_where_the_rest_is_shared(
    composed: Composed, sweeping: Handover
) -> None:
    _job_of(composed(*QUICK, "seed=3"), sweeping)
    with pytest.raises(SettingsError, match="seed: expected"):
        _job_of(composed(*QUICK, "seed=-3"), sweeping)


def test_a_job_that_was_checked_in_this_process_is_not_made_again(composed: Composed, handover: Handover) -> None:
    handover.ready = lambda: 7.0
    assert run_job(composed("rho=2.0")) == 7.0


def test_a_job_that_was_not_is_checked_now(composed: Composed, handover: Handover) -> None:
    with pytest.raises(SettingsError, match=r"^rho: expected"):
        run_job(composed("rho=2.0"))


def test_a_single_job_that_fails_ends_the_program_with_one_line(
    composed: Composed, handover: Handover, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit, match="1") as ended:
        run_job(composed("algo=mmas", "tracking=none", "rho=0"))
    assert isinstance(ended.value.__cause__, SettingsError)
    assert capsys.readouterr().err == f"acoexp: error: {ended.value.__cause__}\n"


def test_a_store_that_is_gone_ends_the_whole_sweep(
    composed: Composed, handover: Handover, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Gone(NoTracker):
        def log(self, *_: Any, **__: Any) -> None:
            raise StoreGoneError("tracking.uri: it is away")

    monkeypatch.setattr("acoexp.command.job.open_tracker", lambda config: Gone())
    with pytest.raises(SystemExit, match="1"):
        run_job(composed(*QUICK, mode=RunMode.MULTIRUN))
    assert capsys.readouterr().err == "acoexp: error: tracking.uri: it is away\n"
