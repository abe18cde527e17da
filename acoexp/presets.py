"""Presets: the algorithms as named combinations of parts, read from the same YAML files that Hydra reads."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import yaml

from acoexp.errors import SettingsError
from acoexp.registry import STRATEGY_GROUPS

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


def preset_names() -> list[str]:
    """Return the names of all presets, sorted."""
    return sorted(path.stem for path in (conf_dir() / "algo").glob("*.yaml"))


def find_preset(name: Any) -> Preset:
    """Return a preset by name.

    Raises:
        SettingsError: if there is no such preset.
    """
    if name not in preset_names():
        raise SettingsError(f"algo: expected one of: {', '.join(preset_names())}; got {name!r}")
    return _read(name)


@cache
def _read(name: str) -> Preset:
    text = (conf_dir() / "algo" / f"{name}.yaml").read_text(encoding="utf-8")
    content = yaml.safe_load(text)
    overrides = (item for entry in content["defaults"] if isinstance(entry, dict) for item in entry.items())
    chosen = {group.removeprefix("override /"): part for group, part in overrides}
    values = {key: value for key, value in content.items() if key not in ("defaults", "algo")}
    return Preset(name, _summary(text), {group: chosen[group] for group in STRATEGY_GROUPS}, values)


def _summary(text: str) -> str:
    """Return a preset's first remark, the one after Hydra's package line."""
    remarks = (line[1:].strip() for line in text.splitlines() if line.startswith("#"))
    return next((remark for remark in remarks if not remark.startswith("@")), "")
