"""Registering: what is declared is offered on the command line, and a folder of one's own besides."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from omegaconf import DictConfig
from running import QUICK, refusal, run_acoexp, trials

from acoexp.command.options.registering import register_options
from acoexp.errors import SettingsError

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


SAYING = """
import sys

class Saying:
    def find_spec(self, name, path=None, target=None):
        if name == "acoexp_paper":
            print("read:", name, file=sys.stderr)

sys.meta_path.insert(0, Saying())
"""


def write(folder: Path, name: str, content: str) -> Path:
    """Write an option file."""
    file = folder / f"{name}.yaml"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(content, encoding="utf-8")
    return file


def test_what_is_of_no_part_stands_at_the_top(composed: Callable[..., DictConfig]) -> None:
    config = composed()
    assert (config.seed, config.seeds, config.threads, config.resume) == (0, None, None, True)
    assert (config.rho, config.field.reach) == (0.5, 4.0)


def test_parts_are_loaded_when_they_are_chosen_or_the_help_is_asked_for(
    tmp_path: Path,
) -> None:
    (tmp_path / "sitecustomize.py").write_text(SAYING, encoding="utf-8")
    saying = {"PYTHONPATH": str(tmp_path)}
    assert run_acoexp("--cfg", "job", cwd=tmp_path, env=saying).stderr == ""
    assert run_acoexp("--help", cwd=tmp_path, env=saying).stderr == "read: acoexp_paper\n"
    assert run_acoexp("report=paper", "--cfg", "job", cwd=tmp_path, env=saying).stderr == "read: acoexp_paper\n"


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
