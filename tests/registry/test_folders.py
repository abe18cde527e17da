"""Folders of configs: acoexp's own, and those of packages that name themselves as bringing presets."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from acoexp.registry.folders import conf_dir, missing_folders, plugin_conf_dirs
from acoexp.registry.presets import preset_names, preset_package

Install = Callable[..., None]

PRESET = "algo: calm\ndefaults: []\n"
BROKEN = {"windy/__init__.py": "1 / 0\n"}
"""Found all the same, as nothing is imported."""


def test_the_programs_own_configs_are_there() -> None:
    assert (conf_dir() / "config.yaml").is_file()
    assert (conf_dir() / "algo" / "pdg.yaml").is_file()


def test_a_package_brings_its_folder_and_nothing_of_it_is_imported(
    install_package: Install, tmp_path: Path
) -> None:
    install_package("windy", "[acoexp.presets]\nany = windy\n", {"windy/conf/algo/calm.yaml": PRESET, **BROKEN})
    assert plugin_conf_dirs()[tmp_path / "windy" / "conf"] == "windy 1.0"
    assert not [said for said in missing_folders() if "windy" in said]
    assert "calm" in preset_names()
    assert preset_package("calm") == "windy 1.0"


def test_folders_stand_in_the_order_of_their_packages_names(install_package: Install, tmp_path: Path) -> None:
    for name in ("windy", "breezy"):
        files = {f"{name}/__init__.py": "", f"{name}/conf/algo/calm.yaml": PRESET}
        install_package(name, f"[acoexp.presets]\nany = {name}\n", files)
    brought = [folder for folder in plugin_conf_dirs() if folder.is_relative_to(tmp_path)]
    assert brought == [tmp_path / "breezy" / "conf", tmp_path / "windy" / "conf"]
    assert preset_package("calm") == "breezy 1.0"


@pytest.mark.parametrize("value", ["no_such_package", "..", "windy"])
def test_a_package_whose_folder_is_not_there_brings_nothing_and_is_told_of(
    value: str, install_package: Install, tmp_path: Path
) -> None:
    install_package("windy", f"[acoexp.presets]\nany = {value}\n", BROKEN)
    said = f"presets of package windy 1.0: expected a package '{value}' with a folder conf/algo"
    assert said in missing_folders()
    assert not [folder for folder in plugin_conf_dirs() if folder.is_relative_to(tmp_path)]


def test_a_folder_without_presets_is_told_of(install_package: Install) -> None:
    install_package("windy", "[acoexp.presets]\nany = windy\n", {"windy/conf/study/x.yaml": "", **BROKEN})
    assert [said for said in missing_folders() if said.startswith("presets of package windy 1.0: ")]
