"""The registry: which parts there are, looked up by name among the installed packages' entry points.

A part is never imported before it is asked for, so one broken package harms nobody else.
"""

from __future__ import annotations

import logging
from collections.abc import Iterable, Mapping
from dataclasses import is_dataclass
from functools import cache
from importlib.metadata import EntryPoint, distributions, entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from acoexp.diagnosis import raised_at
from acoexp.errors import SettingsError, StrategyError, did_you_mean
from acoexp.maps.source import MapSource
from acoexp.parameters import build, check_declarations, fields_of
from acoexp.report.report import Report
from acoexp.strategies.part import CONTRACT, Choice, Diffusion, Heuristic, Post, Update, check_part

log = logging.getLogger(__name__)

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
    """Return the entry points of one group by name, sorted; of several that use one name the first."""
    return {name: claims[0] for name, claims in _claims(group).items()}


@cache
def _claims(group: str) -> dict[str, list[EntryPoint]]:
    """Return by name the entry points that lay claim to it, acoexp's own before all others."""
    found: dict[str, list[EntryPoint]] = {}
    for entry in sorted(entry_points(group=f"acoexp.{group}"), key=lambda e: (e.name, not _is_ours(e))):
        claims = found.setdefault(entry.name, [])
        if entry.value not in [claim.value for claim in claims]:
            claims.append(entry)
    return found


def names(group: str) -> list[str]:
    """Return the names of a group's parts, sorted."""
    return list(entries(group))


def find(group: str, name: Any) -> Any:
    """Return the class registered as ``name`` in ``group``.

    Raises:
        SettingsError: if there is no such name.
        StrategyError: if its package cannot be imported, asks for a newer contract, or shares the name with
            another; a built-in part is found all the same, and the other is left out with a warning.
    """
    if not isinstance(name, str) or name not in entries(group):
        raise SettingsError(not_found(group, name, names(group)))
    _settle(group, name)
    return _load(entries(group)[name], group)


def build_part(group: str, name: Any, parameters: Mapping[str, Any]) -> Any:
    """Return the part registered as ``name`` in ``group``, made from checked parameters.

    Raises:
        SettingsError: if there is no such name, or for a parameter that its declaration does not allow.
        StrategyError: as :func:`find`.
    """
    owner = find(group, name)
    check_keys(group, name, parameters)
    return build(owner, parameters, f"{group}.")


def not_found(group: str, name: Any, known: Iterable[str]) -> str:
    """Say that a group has no part of this name, which it has, and what may have been meant."""
    said = f"{group}: expected one of: {', '.join(known)}; got {name!r}"
    if not isinstance(name, str):
        return said
    others = [other for other in GROUPS if other != group and name in entries(other)]
    if others:
        return f"{said}; there is {' and '.join(f'{other}={name}' for other in others)}"
    astray = [told for entry, told in strays() if entry.name == name]
    return f"{said}; {astray[0]}" if astray else said + did_you_mean(name, known)


def strays() -> list[tuple[EntryPoint, str]]:
    """Return the entry points in groups ``acoexp.*`` that there are not, each with what is to be said of it."""
    found: dict[str, tuple[EntryPoint, str]] = {}
    for entry in (entry for package in distributions() for entry in package.entry_points):
        group = entry.group.removeprefix("acoexp.")
        if group != entry.group and group not in (*GROUPS, "presets"):
            told = (
                f"package {package_named(entry)} registers {entry.name} under {entry.group}, which is no group of "
                f"acoexp's{did_you_mean(entry.group, [f'acoexp.{known}' for known in (*GROUPS, 'presets')])}"
            )
            found[told] = entry, told
    return [found[told] for told in sorted(found)]


def check_keys(group: str, name: str, keys: Iterable[str]) -> None:
    """Refuse parameters that not this part has, but another of its group.

    Raises:
        SettingsError: if there is one.
    """
    own = fields_of(find(group, name))
    for key in keys:
        told = None if key in own else key_of_another(group, name, key)
        if told is not None:
            raise SettingsError(told)


def key_of_another(group: str, name: str, key: str) -> str | None:
    """Say which other parts of a group have a parameter; None if none does. Broken parts are passed over."""
    owners = [other for other in names(group) if other != name and key in _keys(group, other)]
    if not owners:
        return None
    whose = " and ".join(f"{group}={owner}" for owner in owners)
    return f"{group}.{key} is a key of {whose}, not of {group}={name}"


def package_of(group: str, owner: type) -> str | None:
    """Return the package, with its version, that registers a class in a group; None if none does."""
    value = f"{owner.__module__}:{owner.__qualname__}"
    packages = (package_named(entry) for entry in entries(group).values() if entry.value == value)
    return next(packages, None)


def package_named(entry: EntryPoint) -> str:
    """Return the name and version of the package that an entry point is of."""
    try:
        return f"{entry.dist.name} {entry.dist.version}"  # type: ignore[union-attr]
    except Exception:  # none, or its metadata is damaged
        return "an unknown package"


def clash(group: str, name: str) -> str | None:
    """Say which packages use one name; None if only one does."""
    claims = _claims(group)[name]
    if len(claims) == 1:
        return None
    who = " and ".join(f"{package_named(entry)} ({entry.value})" for entry in claims)
    return f"two packages call a {group} {name!r}: {who}; uninstall or rename one of them"


def check_contract(group: str, name: str, owner: type) -> None:
    """Refuse a part that was written for a newer contract than this one, or cannot be one of its group.

    Raises:
        StrategyError: if so.
    """
    package = package_of(group, owner)
    told = f"{group} {name!r}{f' of package {package}' if package else ''}"
    asked: Any = getattr(owner, "contract", CONTRACT)
    if not isinstance(asked, int) or asked > CONTRACT:
        raise StrategyError(
            f"{told} asks for version {asked} of the contract, and this acoexp has version {CONTRACT}; "
            "update acoexp"
        )
    try:
        if package is not None or not is_dataclass(owner):  # else its fields are nobody's business
            check_declarations(owner)
        check_part(owner)
    except (SettingsError, StrategyError) as problem:
        raise StrategyError(f"{told}: {problem}") from problem


@cache
def _settle(group: str, name: str) -> None:
    """Raise if a name stands for two parts, unless one is built in; then the other is told of, once."""
    problem = clash(group, name)
    if problem is not None and not _is_ours(entries(group)[name]):
        raise StrategyError(problem)
    if problem is not None:
        log.warning("%s; until then it is the built-in one", problem)


def _keys(group: str, name: str) -> list[str]:
    try:
        return list(fields_of(find(group, name)))
    except StrategyError:
        return []


@cache
def _load(entry: EntryPoint, group: str) -> Any:
    try:
        part = entry.load()
    except Exception as problem:
        raise StrategyError(
            f"{group} {entry.name!r} of package {package_named(entry)} cannot be imported from {entry.value}: "
            f"{type(problem).__name__}: {problem}{_where(entry, problem)}"
        ) from problem
    kind = {**STRATEGIES, "map": MapSource, "report": Report}.get(group, object)
    if not (isinstance(part, type) and is_dataclass(part) and issubclass(part, kind)):
        raise StrategyError(
            f"{group} {entry.name!r} of package {package_named(entry)}: expected {entry.value} to be a dataclass "
            f"that derives from {kind.__name__}; got {part!r}"
        )
    check_contract(group, entry.name, part)
    return part


def _where(entry: EntryPoint, problem: Exception) -> str:
    """Return the last line of a package's own that the error of its import passed through."""
    try:
        spec = find_spec(entry.value.partition(":")[0].partition(".")[0])
    except (ImportError, ValueError):
        return ""
    files = [] if spec is None else [*(spec.submodule_search_locations or ()), spec.origin or ""]
    place = raised_at(problem, [Path(file) for file in files if file])
    return "" if place is None else f"; {place}"


def _is_ours(entry: EntryPoint) -> bool:
    return entry.dist is not None and package_named(entry).partition(" ")[0] == "acoexp"
