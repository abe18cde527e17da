"""Parts: from a name to the class that is registered under it, checked when it is loaded.

A part that cannot be loaded harms nobody who does not ask for it.
"""

from __future__ import annotations

import logging
from collections.abc import Iterable, Mapping
from dataclasses import is_dataclass
from functools import cache
from importlib.metadata import EntryPoint
from importlib.util import find_spec
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

from acoexp.colony import diagnosis
from acoexp.errors import SettingsError, StrategyError
from acoexp.maps.source import MapSource
from acoexp.parameters import build, check_declarations, fields_of
from acoexp.registry.entries import clash, entries, entry_of, is_ours, not_found, package_named, part_names
from acoexp.strategies.part import CONTRACT, STRATEGIES, check_part

log = logging.getLogger(__name__)

_REPORT = "acoexp.report.report:Report"
"""What a report derives from, by name: reports stand above the registry, and most commands need none."""


def find_part(group: str, name: Any) -> Any:
    """Return the class registered as ``name`` in ``group``.

    Raises:
        SettingsError: if there is no such name.
        StrategyError: if its package cannot be imported, asks for a newer contract, or shares the name with
            another; a built-in part is found all the same, and the other is left out with a warning.
    """
    if not isinstance(name, str) or name not in entries(group):
        raise SettingsError(not_found(group, name, part_names(group)))
    _check_unambiguous(group, name)
    return _load(entries(group)[name], group)


def build_part(group: str, name: Any, parameters: Mapping[str, Any]) -> Any:
    """Return the part registered as ``name`` in ``group``, made from checked parameters.

    Raises:
        SettingsError: if there is no such name, or for a parameter that its declaration does not allow.
        StrategyError: as :func:`find_part`.
    """
    owner = find_part(group, name)
    check_keys(group, name, parameters)
    return build(owner, parameters, f"{group}.")


def check_keys(group: str, name: str, keys: Iterable[str]) -> None:
    """Refuse parameters that not this part has, but another of its group.

    Raises:
        SettingsError: if there is one.
    """
    own = fields_of(find_part(group, name))
    for key in keys:
        refusal = None if key in own else key_of_another(group, name, key)
        if refusal is not None:
            raise SettingsError(refusal)


def key_of_another(group: str, name: str, key: str) -> str | None:
    """Say which other parts of a group have a parameter; None if none does. Broken parts are passed over."""
    owners = [other for other in part_names(group) if other != name and key in _keys(group, other)]
    if not owners:
        return None
    whose = " and ".join(f"{group}={owner}" for owner in owners)
    return f"{group}.{key} is a key of {whose}, not of {group}={name}"


def check_contract(group: str, name: str, owner: type) -> None:
    """Refuse a part that was written for a newer contract than this one, or cannot be one of its group.

    Raises:
        StrategyError: if so.
    """
    entry = entry_of(group, owner)
    described = f"{group} {name!r}" + (f" of package {package_named(entry)}" if entry is not None else "")
    asked: Any = getattr(owner, "contract", CONTRACT)
    if not isinstance(asked, int) or asked > CONTRACT:
        raise StrategyError(
            f"{described} asks for version {asked} of the contract, and this acoexp has version {CONTRACT}; "
            "update acoexp"
        )
    try:
        if entry is not None or not is_dataclass(owner):  # else its fields are nobody's business
            check_declarations(owner)
        check_part(owner)
    except (SettingsError, StrategyError) as problem:
        raise StrategyError(f"{described}: {problem}") from problem


@cache
def _check_unambiguous(group: str, name: str) -> None:
    """Raise if a name stands for two parts, unless one is built in; then the other is warned of, once."""
    problem = clash(group, name)
    if problem is not None and not is_ours(entries(group)[name]):
        raise StrategyError(problem)
    if problem is not None:
        log.warning("%s; until then it is the built-in one", problem)


def _keys(group: str, name: str) -> list[str]:
    try:
        return list(fields_of(find_part(group, name)))
    except StrategyError:
        return []


@cache
def _load(entry: EntryPoint, group: str) -> Any:
    try:
        part = entry.load()
    except KeyboardInterrupt:
        raise
    except BaseException as problem:  # sys.exit() too: a part does not end the program
        raise StrategyError(
            f"{group} {entry.name!r} of package {package_named(entry)} cannot be imported from {entry.value}: "
            f"{type(problem).__name__}: {problem}{diagnosis.at(_line_of_import(entry, problem))}"
        ) from problem
    kind = _kind(group)
    if not (isinstance(part, type) and is_dataclass(part) and issubclass(part, kind)):
        raise StrategyError(
            f"{group} {entry.name!r} of package {package_named(entry)}: expected {entry.value} to be a dataclass "
            f"that derives from {kind.__name__}; got {part!r}"
        )
    check_contract(group, entry.name, part)
    return part


def _kind(group: str) -> type:
    """Return what a part of a group has to derive from."""
    if group in STRATEGIES:
        return STRATEGIES[group]
    report: type = resolve_name(_REPORT)
    return MapSource if group == "map" else report


def _line_of_import(entry: EntryPoint, problem: BaseException) -> diagnosis.Place | None:
    """Return the last line of a package's own that the error of its import passed through."""
    try:
        spec = find_spec(entry.value.partition(":")[0].partition(".")[0])
    except (ImportError, ValueError):
        return None
    files = [] if spec is None else [*(spec.submodule_search_locations or ()), spec.origin or ""]
    return diagnosis.raised_at(problem, [Path(file) for file in files if file])
