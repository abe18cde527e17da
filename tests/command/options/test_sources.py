"""A user's own folder of options: settings of ours are welcome, whatever could run code is not."""

from __future__ import annotations

from pathlib import Path

import pytest
from hydra.errors import HydraException
from running import QUICK, refusal, run_acoexp, trials

from acoexp.command.options.registering import UserOptions

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
HARMLESS = "rho: 0.25\ndiffusion:\n  gamma: 0.5\n"


def write(folder: Path, name: str, content: str) -> Path:
    """Write an option file."""
    file = folder / f"{name}.yaml"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(content, encoding="utf-8")
    return file


def test_an_own_preset_sets_scalars_and_parts(tmp_path: Path) -> None:
    write(tmp_path / "mine", "algo/fast", PRESET)
    ended = run_acoexp("--config-dir", "mine", "algo=fast", "tracking=none", "iterations=3", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    config = trials(tmp_path)[0]["config"]
    assert (config["algo"], config["diffusion.name"], config["rho"], config["ants"]) == (
        "custom",
        "none",
        "0.25",
        "3",
    )


def test_an_own_preset_has_to_say_which_of_ours_it_changes(tmp_path: Path) -> None:
    write(tmp_path / "mine", "algo/fast", "# @package _global_\nrho: 0.25\n")
    assert refusal("-cd", "mine", "algo=fast", *QUICK, cwd=tmp_path).startswith("algo: expected one of: aco, acs")


def test_an_own_group_is_added_in_a_sweep(tmp_path: Path) -> None:
    write(tmp_path / "mine", "study/slow", "# @package _global_\nrho: 0.25\n")
    write(tmp_path / "mine", "study/wide", "# @package _global_\nants: 4\nalpha: 2\n")
    ended = run_acoexp("-m", "+study=slow,wide", "-cd=mine", "tracking=none", "iterations=3", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert {(t["config"]["rho"], t["config"]["ants"]) for t in trials(tmp_path)} == {("0.25", "10"), ("0.5", "4")}


def test_a_folder_that_is_not_there_is_refused(tmp_path: Path) -> None:
    assert refusal("-cd", "nowhere", cwd=tmp_path) == "--config-dir: expected a folder; got 'nowhere'"


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


def load(folder: Path, name: str) -> object:
    """Load an option file as Hydra does."""
    return UserOptions("test", f"options://{folder}").load_config(name).config


@pytest.mark.parametrize("name", ["algo/own", "study/own", "hydraulics/own", "study/hydra_free"])
def test_settings_of_ours_are_read(name: str, tmp_path: Path) -> None:
    write(tmp_path, name, HARMLESS)
    assert load(tmp_path, name) == {"rho": 0.25, "diffusion": {"gamma": 0.5}}


@pytest.mark.parametrize(
    "content",
    [
        "hydra:\n  run:\n    dir: x\n",
        "hydra.run.dir: x\n",
        "# @package hydra\njob:\n  name: x\n",
        "# @package hydra.callbacks.evil\nrho: 1\n",
        "# @package _global_.hydra.callbacks.evil\nrho: 1\n",
        "# @package  hydra.launcher\nrho: 1\n",
        "_target_: os.getcwd\n",
        "diffusion:\n  _target_: os.getcwd\n",
        "diffusion:\n  - [{a: {_target_: os.getcwd}}]\n",
        "defaults:\n  - override /hydra/launcher: joblib\n",
        "defaults:\n  - /hydra/launcher: joblib\n",
        "defaults:\n  - hydra/launcher: joblib\n",
        "defaults:\n  - /hydra/launcher/joblib\n",
        "defaults:\n  - /hydra/launcher/joblib@diffusion\n",
        "defaults:\n  - other@hydra.callbacks.evil: x\n",
        "defaults:\n  - other@_global_.hydra.callbacks.evil: x\n",
        "defaults:\n  - optional other@hydra.callbacks: x\n",
        "defaults:\n  - /other/x@hydra.callbacks.evil\n",
        "defaults:\n  - /other/x@_global_.hydra.callbacks.evil\n",
        "defaults:\n  - override /other@hydra.callbacks: [x, y]\n",
    ],
)
def test_a_file_that_reaches_for_hydra_or_for_code_is_refused(content: str, tmp_path: Path) -> None:
    file = write(tmp_path, "study/evil", content)
    with pytest.raises(HydraException) as caught:
        load(tmp_path, "study/evil")
    assert str(caught.value).startswith(f"{file}: expected settings of acoexp only")


def test_a_file_that_is_no_yaml_is_named(tmp_path: Path) -> None:
    file = write(tmp_path, "study/torn", "rho: [\n")
    with pytest.raises(HydraException, match=r"expected YAML; while parsing") as caught:
        load(tmp_path, "study/torn")
    assert str(caught.value).startswith(str(file))


@pytest.mark.parametrize("name", ["hydra/callbacks/evil", "hydra/evil", "study/hydra/evil"])
def test_a_file_under_a_folder_called_hydra_is_refused(name: str, tmp_path: Path) -> None:
    write(tmp_path, name, HARMLESS)
    with pytest.raises(HydraException, match=name):
        load(tmp_path, name)


@pytest.mark.parametrize("name", ["config", "settings"])
def test_the_programs_own_configuration_cannot_be_replaced_from_the_folder(name: str, tmp_path: Path) -> None:
    """Else a harmless-looking file would switch off the checks that a session makes before it runs."""
    file = write(tmp_path / "mine", name, "seed: 3\nalgo: aco\n")
    assert refusal("-cd", "mine", *QUICK, cwd=tmp_path).startswith(f"{file}: expected ")
