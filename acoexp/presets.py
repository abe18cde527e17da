"""Presets: the algorithms as named combinations of parts, read from the same YAML files that Hydra reads.

A package brings presets of its own by an entry point of the group ``acoexp.presets``, whose value is the
package's name: each file in its folder ``conf/algo`` is one. Nothing of it is imported for that.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import yaml

from acoexp.errors import SettingsError, StrategyError
from acoexp.registry import STRATEGY_GROUPS, entries, not_found, package_named

CUSTOM = "custom"
"""Label of results whose parts are not those of the preset they started from."""


@dataclass(frozen=True)
class Preset:
    """One algorithm.

    Attributes:
        name: Its name, such as ``pdg``.
        summary: What it is, in one line.
        parts: The name of the part in each strategy group.
        values: Settings that it sets, by key; parameters of parts as mappings.
    """

    name: str
    summary: str
    parts: dict[str, str]
    values: dict[str, Any]


def conf_dir() -> Path:
    """Return the folder of Hydra's configs: inside the installed package, or beside it in a checkout."""
    package = Path(__file__).parent
    installed = package / "conf"
    return installed if installed.is_dir() else package.parent / "conf"


@cache
def plugin_conf_dirs() -> dict[Path, str]:
    """Return the folders of configs that other packages bring, each with its package, in order of their names."""
    found: dict[Path, str] = {}
    for entry in _preset_entries():
        for folder in _conf_dirs_of(entry):
            found.setdefault(folder, package_named(entry))
    return found


def faults() -> list[str]:
    """Say of each package that is to bring presets, and whose folder of them is not there, what is wrong."""
    return [
        f"presets of package {package_named(entry)}: expected a package {entry.value!r} with a folder conf/algo"
        for entry in _preset_entries()
        if not any((folder / "algo").is_dir() for folder in _conf_dirs_of(entry))
    ]


def _preset_entries() -> list[EntryPoint]:
    return sorted(entry_points(group="acoexp.presets"), key=lambda entry: (entry.value, entry.name))


def _conf_dirs_of(entry: EntryPoint) -> list[Path]:
    """Return the folders ``conf`` of the package that an entry point names; none if it is not there."""
    try:
        spec = find_spec(entry.value.partition(".")[0].strip())
    except (ImportError, ValueError):
        return []
    folders = (spec.submodule_search_locations if spec is not None else None) or ()
    return [Path(folder, "conf") for folder in folders if Path(folder, "conf").is_dir()]


def preset_names() -> list[str]:
    """Return the names of all presets, sorted."""
    return sorted(_files())


def preset_package(name: str) -> str:
    """Return the package, with its version, that brings a preset."""
    return _files()[name][1]


def _files() -> dict[str, tuple[Path, str]]:
    """Return each preset's file and package; of several that have one name ours, or else the first."""
    folders = {conf_dir(): package_named(entries("diffusion")["none"]), **plugin_conf_dirs()}
    found: dict[str, tuple[Path, str]] = {}
    for folder, package in folders.items():
        for path in sorted((folder / "algo").glob("*.yaml")):
            found.setdefault(path.stem, (path, package))
    return found


def find_preset(name: Any) -> Preset:
    """Return a preset by name.

    Raises:
        SettingsError: if there is no such preset.
        StrategyError: if its file is not one of a preset.
    """
    if not isinstance(name, str) or name not in _files():
        raise SettingsError(not_found("algo", name, preset_names()))
    path, package = _files()[name]
    try:
        return _read(name, path)
    except (OSError, ValueError, LookupError, TypeError, AttributeError, yaml.YAMLError) as problem:
        reason = " ".join(f"{type(problem).__name__}: {problem}".split())
        raise StrategyError(
            f"algo {name!r} of package {package}: expected {path} to say algo: {name}, and in its defaults "
            f"override /{', /'.join(STRATEGY_GROUPS)}; {reason}"
        ) from problem


def told(name: str) -> str:
    """Return the words for a preset, with its package and its file."""
    path, package = _files()[name]
    return f"algo {name!r} of package {package}, {path}"


@cache
def _read(name: str, path: Path) -> Preset:
    text = path.read_text(encoding="utf-8")
    content = yaml.safe_load(text)
    if content["algo"] != name:
        raise ValueError(f"it says algo: {content['algo']}")
    overrides = (item for entry in content["defaults"] if isinstance(entry, dict) for item in entry.items())
    chosen = {group.removeprefix("override /"): part for group, part in overrides}
    values = {key: value for key, value in content.items() if key not in ("defaults", "algo")}
    return Preset(name, _summary(text), {group: chosen[group] for group in STRATEGY_GROUPS}, values)


def _summary(text: str) -> str:
    """Return a preset's first remark, the one after Hydra's package line."""
    remarks = (line[1:].strip() for line in text.splitlines() if line.startswith("#"))
    return next((remark for remark in remarks if not remark.startswith("@")), "")
