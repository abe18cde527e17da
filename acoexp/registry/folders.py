"""Folders of configs: acoexp's own, and those that other packages bring.

A package brings presets by an entry point of the group ``acoexp.presets``, whose value is the package's name: each
file in its folder ``conf/algo`` is one. Nothing of it is imported for that.
"""

from __future__ import annotations

from functools import cache
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path

from acoexp.registry.entries import PRESETS, package_named


def conf_dir() -> Path:
    """Return the folder of Hydra's configs: inside the installed package, or beside it in a checkout."""
    package = Path(__file__).parents[1]
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


def missing_folders() -> list[str]:
    """Say of each package that is to bring presets, and whose folder of them is not there, what is wrong."""
    return [
        f"presets of package {package_named(entry)}: expected a package {entry.value!r} with a folder conf/algo"
        for entry in _preset_entries()
        if not any((folder / "algo").is_dir() for folder in _conf_dirs_of(entry))
    ]


def _preset_entries() -> list[EntryPoint]:
    return sorted(entry_points(group=f"acoexp.{PRESETS}"), key=lambda entry: (entry.value, entry.name))


def _conf_dirs_of(entry: EntryPoint) -> list[Path]:
    """Return the folders ``conf`` of the package that an entry point names; none if it is not there."""
    try:
        spec = find_spec(entry.value.partition(".")[0].strip())
    except (ImportError, ValueError):
        return []
    folders = (spec.submodule_search_locations if spec is not None else None) or ()
    return [Path(folder, "conf") for folder in folders if Path(folder, "conf").is_dir()]
