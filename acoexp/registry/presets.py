"""Presets: the algorithms as named combinations of parts, read from the same YAML files that Hydra reads."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from acoexp.errors import SettingsError, StrategyError
from acoexp.registry.entries import entries, not_found, package_named
from acoexp.registry.folders import conf_dir, plugin_conf_dirs
from acoexp.strategies.groups import STRATEGY_GROUPS

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


def describe_preset(name: str) -> str:
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
