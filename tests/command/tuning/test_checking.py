"""What is checked before a study begins: its jobs' ends, the missing extra, and that its database is its own."""

from __future__ import annotations

import sys
from collections.abc import Callable

import pytest
from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from omegaconf import DictConfig

from acoexp.command.handover import Handover
from acoexp.command.sweep.plan import Plan
from acoexp.command.tuning.checking import check_installed, checked_plan
from acoexp.command.tuning.space import Space
from acoexp.errors import SettingsError

Composed = Callable[..., DictConfig]


def plan(composed: Composed, *overrides: str, storage: str | None = None) -> Plan:
    """Return the plan of a study's jobs."""
    space = Space(OverridesParser.create().parse_overrides([*overrides, "iterations=3"]))
    return checked_plan(composed(), GlobalHydra.instance().config_loader(), space, storage)


def test_the_plan_has_a_job_for_each_choice_and_both_ends(composed: Composed, handover: Handover) -> None:
    found = plan(composed, "rho=interval(0.1,0.9)", "map=fig13,env1,env2", "tracking=none")
    assert [(job.config["map"]["name"], job.config["rho"]) for job in found.jobs.values()] == [
        ("fig13", 0.1),
        ("env1", 0.9),
        ("env2", 0.9),
    ]


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("rho=interval(0.5,1.5)", "rho: expected a number from 0 to 1; got 1.5"),
        ("ants=int(interval(0,9))", "ants: expected a whole number from 1 to 100000; got 0"),
        ("ants=interval(1,9)", "ants: expected a whole number from 1 to 100000; got 1.0"),
    ],
)
def test_an_end_that_no_job_takes_is_refused(
    override: str, said: str, composed: Composed, handover: Handover
) -> None:
    with pytest.raises(SettingsError) as caught:
        plan(composed, override, "tracking=none")
    assert str(caught.value) == said


def test_a_report_has_no_length_to_go_by(composed: Composed, handover: Handover) -> None:
    with pytest.raises(SettingsError, match=r"^report: expected none with hydra/sweeper=optuna"):
        plan(composed, "rho=interval(0.5,0.9)", "report=compare", "tracking=none")


def test_the_store_of_trials_is_no_place_for_a_study(composed: Composed, handover: Handover) -> None:
    with pytest.raises(SettingsError, match=r"^hydra\.sweeper\.storage: expected a database of its own"):
        plan(composed, "rho=interval(0.5,0.9)", storage="sqlite:///outputs/mlflow.db")
    plan(composed, "rho=interval(0.5,0.9)", storage="sqlite:///outputs/study.db")


@pytest.mark.parametrize("package", ["optuna", "cmaes"])
def test_what_is_not_installed_is_told_with_the_command_that_installs_it(
    package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(SettingsError) as caught:
        check_installed()
    assert str(caught.value) == 'hydra/sweeper: optuna needs `pip install "acoexp[optuna]"`'
