"""``--help`` and its kin: everything that there is to say is said, quickly."""

from __future__ import annotations

import os
import subprocess
import sysconfig
from importlib.metadata import entry_points
from pathlib import Path

import pytest
import yaml
from running import QUICK, environment, run_acoexp

from acoexp.command.options.help import help_text
from acoexp.errors import StrategyError
from acoexp.parameters import fields_of
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.parts import find_part
from acoexp.registry.presets import preset_names


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> str:
    """Return what --help prints."""
    ended = run_acoexp("--help", cwd=tmp_path_factory.mktemp("help"))
    assert (ended.returncode, ended.stderr) == (0, "")
    return ended.stdout


def section(page: str, title: str) -> str:
    """Return one section of the page."""
    return page.partition(f"== {title}:")[2].partition("\n== ")[0]


@pytest.mark.parametrize("group", GROUPS)
def test_help_names_every_option_of_a_group_and_its_keys(page: str, group: str) -> None:
    lines = section(page, group).splitlines()
    for name in part_names(group):
        assert any(line.split()[:1] == [name] and len(line.split()) > 2 for line in lines), name
        for key in fields_of(find_part(group, name)):
            assert any(line.split()[:1] == [f"{group}.{key}:"] for line in lines), key


def test_help_names_every_preset_and_tracker(page: str) -> None:
    for title, names in (("algo", preset_names()), ("tracking", ["mlflow", "none"]), ("report", ["none"])):
        first_words = {line.split()[0] for line in section(page, title).splitlines()[1:] if line.strip()}
        assert first_words >= set(names)


@pytest.mark.parametrize(
    "key", ["seed", "alpha", "beta", "rho", "ants", "iterations", "q", "tau0", "field.reach", "-m", "--cfg"]
)
def test_help_names_every_key(page: str, key: str) -> None:
    assert f" {key} " in page or f"\n{key} " in page


def test_help_names_the_key_that_all_reports_have(page: str) -> None:
    lines = [line for line in section(page, "report").splitlines() if line.split()[:1] == ["report.folder"]]
    assert len(lines) == 1


def test_help_names_all_values_of_a_key_that_has_few(page: str) -> None:
    assert "[edges, or cells]" in section(page, "keys")
    assert "[force_edge, or walked_edge, sum_in, mean_out, max_out]" in section(page, "diffusion")


def test_help_leaves_no_mark_of_its_template(page: str) -> None:
    assert "$$" not in page
    assert 'eval "$(acoexp -sc install=bash)"' in page


def test_help_says_which_part_is_broken(monkeypatch: pytest.MonkeyPatch) -> None:
    def find(group: str, name: str) -> object:
        raise StrategyError(f"{name} cannot be imported")

    monkeypatch.setattr("acoexp.command.options.help.find_part", find)
    assert "BROKEN: gaussian cannot be imported" in help_text()


def test_cfg_shows_the_resolved_settings(tmp_path: Path) -> None:
    ended = run_acoexp("--cfg", "job", "algo=pd", "rho=0.25", "map=env2", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    shown = yaml.safe_load(ended.stdout)
    assert (shown["algo"], shown["rho"], shown["map"]["name"]) == ("pd", 0.25, "env2")
    assert shown["diffusion"]["name"] == "gaussian"
    assert list(tmp_path.iterdir()) == []


def test_info_shows_where_settings_come_from(tmp_path: Path) -> None:
    ended = run_acoexp("map=env2", "--info", "defaults", cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert "map/env2" in ended.stdout


def loaded(*args: str, cwd: Path) -> set[str]:
    """Return the names of all modules that a run loads."""
    ended = run_acoexp(*args, cwd=cwd, python=["-X", "importtime"])
    assert ended.returncode == 0, ended.stderr
    lines = ended.stderr.splitlines()
    return {line.rpartition("|")[2].strip() for line in lines if line.startswith("import time:")}


@pytest.mark.parametrize("args", [("--help",), ("--cfg", "job"), (*QUICK, "-m", "seed=0,1")])
def test_neither_mlflow_nor_matplotlib_is_loaded_where_it_is_not_needed(
    args: tuple[str, ...], tmp_path: Path
) -> None:
    modules = loaded(*args, cwd=tmp_path)
    assert "hydra" in modules
    assert not modules & {"mlflow", "matplotlib", "matplotlib.pyplot"}


def test_a_console_script_is_declared() -> None:
    (script,) = entry_points(group="console_scripts", name="acoexp")
    assert script.value == "acoexp.__main__:main"


@pytest.mark.parametrize(
    ("typed", "proposed"),
    [("acoexp algo=p", "algo=pdg"), ("acoexp -m map=en", "map=env2"), ("acoexp map=env2 -m algo=p", "algo=pd")],
)
def test_the_console_script_completes(typed: str, proposed: str, tmp_path: Path) -> None:
    script = Path(sysconfig.get_path("scripts"), "acoexp")
    ended = subprocess.run(
        [script, "-sc", "query=bash"],
        env=environment({"COMP_LINE": typed, "COMP_POINT": str(len(typed)), "PATH": os.defpath}),
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    assert proposed in ended.stdout.split()
