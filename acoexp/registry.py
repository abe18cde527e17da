"""The registry: which parts there are, looked up by name among the installed packages' entry points.

A part is never imported before it is asked for, so one broken package harms nobody else.
"""

from __future__ import annotations

from dataclasses import is_dataclass
from functools import cache
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from acoexp.errors import SettingsError, StrategyError
from acoexp.maps.source import MapSource
from acoexp.strategies.part import Choice, Diffusion, Heuristic, Post, Update

STRATEGIES: dict[str, type] = {
    "heuristic": Heuristic,
    "choice": Choice,
    "diffusion": Diffusion,
    "post": Post,
    "update": Update,
}
"""The five parts of a colony, in the order in which an ant meets them, and what each has to be."""

STRATEGY_GROUPS = tuple(STRATEGIES)

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


def find(group: str, name: Any) -> Any:
    """Return the class registered as ``name`` in ``group``.

    Raises:
        SettingsError: if there is no such name.
        StrategyError: if its package cannot be imported.
    """
    if not isinstance(name, str) or name not in entries(group):
        raise SettingsError(f"{group}: expected one of: {', '.join(names(group))}; got {name!r}")
    return _load(entries(group)[name], group)


@cache
def _load(entry: EntryPoint, group: str) -> Any:
    try:
        part = entry.load()
    except Exception as problem:
        raise StrategyError(
            f"{group} {entry.name!r} of package {_package(entry)} cannot be imported from {entry.value}: "
            f"{type(problem).__name__}: {problem}"
        ) from problem
    kind = {**STRATEGIES, "map": MapSource}.get(group, object)
    if not (isinstance(part, type) and is_dataclass(part) and issubclass(part, kind)):
        raise StrategyError(
            f"{group} {entry.name!r} of package {_package(entry)}: expected {entry.value} to be a dataclass that "
            f"derives from {kind.__name__}; got {part!r}"
        )
    return part


def _package(entry: EntryPoint) -> str:
    return f"{entry.dist.name} {entry.dist.version}" if entry.dist else "an unknown package"
