"""Entries: which parts the installed packages register by entry point, under which names. Nothing is imported."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from importlib.metadata import Distribution, EntryPoint, distributions, entry_points
from pathlib import Path

from acoexp.errors import did_you_mean, shown
from acoexp.strategies.groups import STRATEGY_GROUPS

GROUPS = (*STRATEGY_GROUPS, "map", "report")
"""All groups of parts; the entry points of group ``g`` stand under ``acoexp.g``."""

PRESETS = "presets"
"""The group under which packages name themselves as bringing presets."""


@cache
def entries(group: str) -> dict[str, EntryPoint]:
    """Return the entry points of one group by name, sorted; of several that use one name the first."""
    return {name: claims[0] for name, claims in _claims(group).items()}


@cache
def _claims(group: str) -> dict[str, list[EntryPoint]]:
    """Return by name the entry points that lay claim to it, acoexp's own before all others."""
    found: dict[str, list[EntryPoint]] = {}
    for entry in sorted(entry_points(group=f"acoexp.{group}"), key=lambda e: (e.name, not is_ours(e))):
        claims = found.setdefault(entry.name, [])
        if entry.value not in [claim.value for claim in claims]:
            claims.append(entry)
    return found


def part_names(group: str) -> list[str]:
    """Return the names of a group's parts, sorted."""
    return list(entries(group))


def entry_of(group: str, owner: type) -> EntryPoint | None:
    """Return the entry point that registers a class in a group; None if none does."""
    value = f"{owner.__module__}:{owner.__qualname__}"
    return next((entry for entry in entries(group).values() if entry.value == value), None)


def not_found(group: str, name: object, known: Iterable[str]) -> str:
    """Say that a group has no part of this name, which it has, and what may have been meant."""
    said = f"{group}: expected one of: {', '.join(known)}; got {shown(name)}"
    if not isinstance(name, str):
        return said
    if group == "map" and re.fullmatch(r"[\w./-]+", name) and Path(name).is_file():
        return f"{said}; for a file: map=file map.path={name}"
    others = [other for other in GROUPS if other != group and name in entries(other)]
    if others:
        return f"{said}; there is {' and '.join(f'{other}={name}' for other in others)}"
    misplaced = [described for entry, described in misplaced_entries() if entry.name == name]
    return f"{said}; {misplaced[0]}" if misplaced else said + did_you_mean(name, known)


def misplaced_entries() -> list[tuple[EntryPoint, str]]:
    """Return the entry points in groups ``acoexp.*`` that do not exist, each with what is to be said of it."""
    groups = (*GROUPS, PRESETS)
    found: dict[str, tuple[EntryPoint, str]] = {}
    for entry in (entry for package in distributions() for entry in package.entry_points):
        group = entry.group.removeprefix("acoexp.")
        if group != entry.group and group not in groups:
            described = (
                f"package {package_named(entry)} registers {entry.name} under {entry.group}, which is no group of "
                f"acoexp's{did_you_mean(entry.group, [f'acoexp.{known}' for known in groups])}"
            )
            found[described] = entry, described
    return [found[described] for described in sorted(found)]


def package_named(entry: EntryPoint) -> str:
    """Return the name and version of the package that an entry point is of."""
    try:
        return _named(entry.dist)
    except Exception:  # none, or its metadata is damaged
        return "an unknown package"


@cache
def _named(package: Distribution) -> str:
    """Return the name and version of a package, whose metadata are read once for all of its entry points."""
    return f"{package.name} {package.version}"


def clash(group: str, name: str) -> str | None:
    """Say which packages use one name; None if only one does."""
    claims = _claims(group)[name]
    if len(claims) == 1:
        return None
    who = " and ".join(f"{package_named(entry)} ({entry.value})" for entry in claims)
    return f"two packages call a {group} {name!r}: {who}; uninstall or rename one of them"


def is_ours(entry: EntryPoint) -> bool:
    """Tell whether an entry point is acoexp's own."""
    return entry.dist is not None and package_named(entry).partition(" ")[0] == "acoexp"
