"""The session: Hydra tells it of the one job before that runs, and what is wrong then ends the program."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hydra.types import RunMode
from omegaconf import DictConfig, open_dict, read_write
from running import listing

from acoexp.command.handover import Handover
from acoexp.command.sweep.callback import OWN_SWEEPERS, Session
from acoexp.tracking.tracker import NoTracker

Composed = Callable[..., DictConfig]
Capture = pytest.CaptureFixture[str]

QUICK = ("algo=aco", "tracking=none", "iterations=3", "ants=2")


def test_a_job_that_is_right_is_ready_to_run_and_its_store_too(
    composed: Composed, handover: Handover, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[str] = []
    monkeypatch.setattr(NoTracker, "check", lambda self: done.append("looked at"))
    monkeypatch.setattr(NoTracker, "prepare", lambda self: done.append("made ready"))
    Session().on_run_start(composed(*QUICK))
    assert done == ["looked at"]
    assert handover.ready is not None
    assert handover.ready() > 0.0
    assert done == ["looked at", "made ready"]
    Session().on_run_start(composed(*QUICK, "seeds='0-1'"))
    assert done[2:] == ["made ready"]


def test_a_job_that_is_wrong_ends_the_program_in_one_line_with_nothing_written(
    composed: Composed, handover: Handover, tmp_path: Path, capsys: Capture
) -> None:
    with pytest.raises(SystemExit, match="1"):
        Session().on_run_start(composed("rho=2.0"))
    assert capsys.readouterr().err == "acoexp: error: rho: expected a number from 0 to 1; got 2.0\n"
    assert listing(tmp_path) == {"job"}


def test_what_nobody_foresaw_ends_it_with_a_traceback(
    composed: Composed, handover: Handover, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    def fail(self: Any) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(NoTracker, "check", fail)
    with pytest.raises(SystemExit, match="1"):
        Session().on_run_start(composed(*QUICK))
    assert capsys.readouterr().err.rstrip().endswith("ZeroDivisionError")


@pytest.mark.parametrize(("mode", "launcher"), [(RunMode.RUN, "acoexp"), (RunMode.MULTIRUN, "basic")])
def test_passwords_in_what_hydra_writes_of_a_job_are_masked(
    mode: RunMode, launcher: str, composed: Composed, tmp_path: Path
) -> None:
    config = composed("tracking.uri='http://me:geheim99@host'", f"hydra/launcher={launcher}", mode=mode)
    written = tmp_path / "job" / ".hydra" / "config.yaml"
    written.parent.mkdir()
    written.write_text("uri: http://me:geheim99@host\nother: geheim99\n", encoding="utf-8")
    Session().on_job_start(config)
    assert written.read_text(encoding="utf-8") == "uri: http://***@host\nother: ***\n"


@pytest.mark.parametrize("sweeper", ["acoexp", "optuna"])
def test_a_sweep_of_our_own_is_left_to_our_sweeper(sweeper: str, composed: Composed, handover: Handover) -> None:
    config = composed("rho=2.0", f"hydra/sweeper={sweeper}")
    assert config.hydra.sweeper._target_ in OWN_SWEEPERS
    Session().on_multirun_start(config)


def test_of_another_sweepers_jobs_what_is_known_is_checked(
    composed: Composed, handover: Handover, capsys: Capture
) -> None:
    config = composed("hydra/sweeper=basic", "beta=-1")
    with read_write(config.hydra), open_dict(config.hydra):
        config.hydra.overrides.task.append("rho=interval(0,1)")  # what it will choose from
    with pytest.raises(SystemExit, match="1"):
        Session().on_multirun_start(config)
    assert capsys.readouterr().err == "acoexp: error: beta: expected a number from 0 to 100; got -1\n"
