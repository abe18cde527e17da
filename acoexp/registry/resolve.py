"""Resolving: what a user says becomes checked settings; the one way in, for Python and the command line."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import Any

from acoexp.colony.scalars import ColonySettings
from acoexp.errors import SettingsError, StrategyError, did_you_mean, shown
from acoexp.grid.field import FieldSettings
from acoexp.parameters import build, check, fields_of, values_of
from acoexp.registry.entries import entries, entry_of, package_named
from acoexp.registry.parts import build_part, check_contract
from acoexp.registry.presets import CUSTOM, Preset, describe_preset, find_preset
from acoexp.strategies.groups import STRATEGY_GROUPS
from acoexp.strategies.part import STRATEGIES
from acoexp.trial.settings import Chosen, Settings


def resolve(algo: Any, values: Mapping[str, Any]) -> Settings:
    """Resolve settings.

    Args:
        algo: Name of a preset.
        values: By key: scalars; ``field`` as a mapping; parts as a registered name, a mapping of parameters
            (with ``name``, or else of the preset's own part), or an object.

    Raises:
        SettingsError: for an unknown key or name, and for any value that its declaration does not allow.
        StrategyError: for a part whose package cannot be imported, that asks for a newer contract or cannot be a
            part of its group; and for a preset that sets what no settings can be.
    """
    preset = find_preset(algo)
    try:
        return _resolve(preset, values)
    except SettingsError as problem:
        if _refusal(preset) == str(problem):
            raise StrategyError(f"{describe_preset(preset.name)}: {problem}") from problem
        raise


def _refusal(preset: Preset) -> str | None:
    """Return what is wrong with a preset by itself, if anything is."""
    try:
        _resolve(preset, {})
    except SettingsError as problem:
        return str(problem)
    return None


def _resolve(preset: Preset, values: Mapping[str, Any]) -> Settings:
    given = _merge(preset.values, values)
    known = {*fields_of(ColonySettings), *STRATEGY_GROUPS, "field"}
    for key in given:
        if key not in known:
            like = did_you_mean(key, known)
            raise SettingsError(f"{key} is not a known key; expected one of: {', '.join(sorted(known))}{like}")
    chosen = {g: _chosen(g, given.get(g, {}), preset.parts[g]) for g in STRATEGY_GROUPS}
    names = {group: one.name for group, one in chosen.items()}
    scalars = {key: value for key, value in given.items() if key in fields_of(ColonySettings)}
    return Settings(
        label=preset.name if names == preset.parts else CUSTOM,
        scalars=build(ColonySettings, scalars),
        field=build(FieldSettings, _mapping("field", given.get("field", {})), "field."),
        chosen=chosen,
    )


def _chosen(group: str, given: Any, preset_name: str) -> Chosen:
    """Return the part that is given as an object, a name, or a mapping of parameters."""
    if isinstance(given, STRATEGIES[group]):
        return _made(group, given)
    if isinstance(given, str):
        given = {"name": given}
    parameters = dict(_mapping(group, given))
    name = parameters.pop("name", preset_name)
    part = build_part(group, name, parameters)
    return Chosen(name, package_named(entries(group)[name]), part)


def _made(group: str, part: Any) -> Chosen:
    """Return a part that was made in Python, checked as if it were named."""
    entry = entry_of(group, type(part))
    name = type(part).__name__ if entry is None else entry.name
    check_contract(group, name, type(part))
    if is_dataclass(part):
        check(type(part), values_of(part), f"{group}.")
    return Chosen(name, None if entry is None else package_named(entry), part)


def _mapping(key: str, given: Any) -> Mapping[str, Any]:
    if not isinstance(given, Mapping):
        part = f", a name or a {STRATEGIES[key].__name__} object" if key in STRATEGIES else ""
        raise SettingsError(f"{key}: expected a mapping of parameters{part}; got {shown(given)}")
    return given


def _merge(preset: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """Lay what was given over what the preset says, parameter by parameter where both are mappings."""
    merged = {**preset, **given}
    for key in preset.keys() & given.keys():
        if isinstance(preset[key], Mapping) and isinstance(given[key], Mapping) and "name" not in given[key]:
            merged[key] = {**preset[key], **given[key]}
    return merged
