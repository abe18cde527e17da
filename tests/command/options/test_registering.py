"""Registering: what is declared is offered on the command line, and a folder of one's own besides."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hydra.core.config_store import ConfigStore
from omegaconf import DictConfig, OmegaConf
from running import QUICK, refusal, run_acoexp, trials

from acoexp.command.options import registering
from acoexp.command.options.registering import register_options
from acoexp.errors import SettingsError, StrategyError
from acoexp.parameters import defaults_of
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.parts import find_part
from acoexp.tracking.options import TRACKING

PRESET = """\
# @package _global_
defaults:
  - override /diffusion: none
  - override /post: none
  - override /update: ant_cycle

algo: pdg
rho: 0.25
ants: 3
"""


def write(folder: Path, name: str, content: str) -> Path:
    """Write an option file."""
    file = folder / f"{name}.yaml"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(content, encoding="utf-8")
    return file


def option(group: str, name: str) -> Any:
    """Return an option as Hydra has it."""
    return OmegaConf.to_container(ConfigStore.instance().load(f"{group}/{name}.yaml").node)


@pytest.mark.parametrize("group", GROUPS)
def test_each_part_is_an_option_with_its_parameters_and_their_defaults(hydra: None, group: str) -> None:
    for name in part_names(group):
        defaults = defaults_of(find_part(group, name))
        plain = {key: list(value) if isinstance(value, tuple) else value for key, value in defaults.items()}
        shared = {"folder": None} if group == "report" else {}
        assert option(group, name) == {"name": name, **shared, **plain}


def test_there_may_be_no_report_and_no_tracking(hydra: None) -> None:
    assert option("report", "none") == {"name": "none"}
    assert option("tracking", "none") == {"name": "none"}
    assert option("tracking", "mlflow") == {"name": "mlflow", **defaults_of(TRACKING["mlflow"])}


def test_what_is_of_no_part_stands_at_the_top(composed: Callable[..., DictConfig]) -> None:
    config = composed()
    assert (config.seed, config.seeds, config.threads, config.resume) == (0, None, None, True)
    assert (config.rho, config.field.reach) == (0.5, 4.0)


def test_a_broken_part_is_offered_without_parameters_and_harms_nobody(
    hydra: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    def find(group: str, name: str, real: Any = find_part) -> Any:
        if name == "luo_wu":
            raise StrategyError("luo_wu cannot be imported")
        return real(group, name)

    with monkeypatch.context() as broken:
        broken.setattr(registering, "find_part", find)
        register_options(None)
        assert option("diffusion", "luo_wu") == {"name": "luo_wu"}
        assert "gamma" in option("diffusion", "gaussian")
    register_options(None)
    assert "gamma" in option("diffusion", "luo_wu")


def test_a_folder_that_is_not_there_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SettingsError, match=r"^--config-dir: expected a folder; got 'nowhere'$"):
        register_options("nowhere")


def test_an_own_preset_sets_scalars_and_parts(tmp_path: Path) -> None:
    write(tmp_path / "mine", "algo/fast", PRESET)
    ended = run_acoexp("--config-dir", "mine", "algo=fast", "tracking=none", "iterations=3", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    config = trials(tmp_path)[0]["config"]
    assert (config["algo"], config["diffusion.name"]) == ("custom", "none")
    assert (config["rho"], config["ants"]) == ("0.25", "3")


def test_an_own_preset_has_to_say_which_of_ours_it_changes(tmp_path: Path) -> None:
    write(tmp_path / "mine", "algo/fast", "# @package _global_\nrho: 0.25\n")
    assert refusal("-cd", "mine", "algo=fast", *QUICK, cwd=tmp_path).startswith("algo: expected one of: aco, acs")


def test_an_own_group_is_added_in_a_sweep(tmp_path: Path) -> None:
    write(tmp_path / "mine", "study/slow", "# @package _global_\nrho: 0.25\n")
    write(tmp_path / "mine", "study/wide", "# @package _global_\nants: 4\nalpha: 2\n")
    ended = run_acoexp("-m", "+study=slow,wide", "-cd=mine", "tracking=none", "iterations=3", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert {(t["config"]["rho"], t["config"]["ants"]) for t in trials(tmp_path)} == {("0.25", "10"), ("0.5", "4")}


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("study/evil", "# @package _global_\nhydra:\n  job:\n    name: x\n"),
        ("study/evil", "# @package hydra.callbacks.evil\n_target_: os.system\n"),
        ("hydra/callbacks/evil", "rho: 0.25\n"),
    ],
)
def test_what_reaches_for_hydra_ends_the_program_before_anything_is_written(
    name: str, content: str, tmp_path: Path
) -> None:
    file = write(tmp_path / "mine", name, content)
    message = refusal(f"+{name.replace('/evil', '=evil')}", *QUICK, "--config-dir=mine", cwd=tmp_path)
    assert message.startswith(f"{file}: expected settings of acoexp only")


def test_the_programs_own_configuration_cannot_be_replaced(tmp_path: Path) -> None:
    file = write(tmp_path / "mine", "config", "seed: 3\nalgo: aco\n")
    assert refusal("-cd", "mine", *QUICK, cwd=tmp_path).startswith(f"{file}: expected ")
