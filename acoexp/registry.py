"""The registry: which parts there are, looked up by name among the installed packages' entry points.

A part is never imported before it is asked for, so one broken package harms nobody else.
"""

from __future__ import annotations

from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from acoexp.errors import SettingsError, StrategyError

STRATEGY_GROUPS = ("heuristic", "choice", "diffusion", "post", "update")
"""The five parts of a colony, in the order in which an ant meets them."""

GROUPS = (*STRATEGY_GROUPS, "map", "report")
"""All groups; the entry points of group ``g`` stand under ``acoexp.g``."""


@cache
def entries(group: str) -> dict[str, EntryPoint]:
    """Return the entry points of one group by name, sorted.

    Raises:
        StrategyError: if two packages use one name.
    """
    found: dict[str, EntryPoint] = {}
    for entry in sorted(entry_points(group=f"acoexp.{group}"), key=lambda e: e.name):
        other = found.get(entry.name)
        if other is not None and other.value != entry.value:
            raise StrategyError(
                f"two packages call a {group} {entry.name!r}: {_package(other)} ({other.value}) and "
                f"{_package(entry)} ({entry.value}); uninstall or rename one of them"
            )
        found[entry.name] = entry
    return found


def names(group: str) -> list[str]:
    """Return the names of a group's parts, sorted."""
    return list(entries(group))


@cache
def find(group: str, name: str) -> Any:
    """Return the class registered as ``name`` in ``group``.

    Raises:
        SettingsError: if there is no such name.
        StrategyError: if its package cannot be imported.
    """
    entry = entries(group).get(name)
    if entry is None:
        raise SettingsError(f"{group}: expected one of: {', '.join(names(group))}; got {name!r}")
    try:
        return entry.load()
    except Exception as problem:
        raise StrategyError(
            f"{group} {name!r} of package {_package(entry)} cannot be imported from {entry.value}: "
            f"{type(problem).__name__}: {problem}"
        ) from problem


def _package(entry: EntryPoint) -> str:
    return f"{entry.dist.name} {entry.dist.version}" if entry.dist else "an unknown package"
