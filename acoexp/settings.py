"""Settings: what a user says, resolved into checked parts and scalars; the one way in, for Python and Hydra."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, is_dataclass
from typing import Any

from acoexp import registry
from acoexp.colony.problem import ColonySettings
from acoexp.errors import SettingsError, StrategyError, did_you_mean
from acoexp.field import FieldSettings
from acoexp.parameters import build, check, fields_of, values_of
from acoexp.presets import CUSTOM, Preset, find_preset, told
from acoexp.registry import STRATEGIES, STRATEGY_GROUPS


@dataclass(frozen=True)
class Settings:
    """Everything about a trial but its map and its seed, checked.

    Attributes:
        label: The preset's name, or ``custom`` where one of its parts was replaced.
        scalars: The colony's scalars.
        field: The potential field's constants.
        parts: The part in each strategy group.
        names: The name of each part: as registered, or its class's name if it is not.
    """

    label: str
    scalars: ColonySettings
    field: FieldSettings
    parts: dict[str, Any]
    names: dict[str, str]

    def as_dict(self) -> dict[str, Any]:
        """Return everything as plain values, nested as on the command line: ``diffusion.gamma`` and so on."""
        parts = {group: {"name": self.names[group], **values_of(part)} for group, part in self.parts.items()}
        return {"algo": self.label, **values_of(self.scalars), "field": values_of(self.field), **parts}


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
            raise StrategyError(f"{told(preset.name)}: {problem}") from problem
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
    named = {g: _part(g, given.get(g, {}), preset.parts[g]) for g in STRATEGY_GROUPS}
    names = {group: name for group, (name, _) in named.items()}
    scalars = {key: value for key, value in given.items() if key in fields_of(ColonySettings)}
    return Settings(
        label=preset.name if names == preset.parts else CUSTOM,
        scalars=build(ColonySettings, scalars),
        field=build(FieldSettings, _mapping("field", given.get("field", {})), "field."),
        parts={group: part for group, (_, part) in named.items()},
        names=names,
    )


def _part(group: str, given: Any, preset_name: str) -> tuple[str, Any]:
    """Return a part's name and the part itself."""
    if isinstance(given, STRATEGIES[group]):
        name = _registered_name(group, type(given))
        registry.check_contract(group, name, type(given))
        if is_dataclass(given):
            check(type(given), values_of(given), f"{group}.")
        return name, given
    if isinstance(given, str):
        given = {"name": given}
    parameters = dict(_mapping(group, given))
    name = parameters.pop("name", preset_name)
    return name, registry.build_part(group, name, parameters)


def _mapping(key: str, given: Any) -> Mapping[str, Any]:
    if not isinstance(given, Mapping):
        part = f", a name or a {STRATEGIES[key].__name__} object" if key in STRATEGIES else ""
        raise SettingsError(f"{key}: expected a mapping of parameters{part}; got {given!r}")
    return given


def _registered_name(group: str, owner: type) -> str:
    """Return the name under which a part's class is registered, without importing anything."""
    value = f"{owner.__module__}:{owner.__qualname__}"
    names = (name for name, entry in registry.entries(group).items() if entry.value == value)
    return next(names, owner.__name__)


def _merge(preset: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """Lay what was given over what the preset says, parameter by parameter where both are mappings."""
    merged = {**preset, **given}
    for key in preset.keys() & given.keys():
        if isinstance(preset[key], Mapping) and isinstance(given[key], Mapping) and "name" not in given[key]:
            merged[key] = {**preset[key], **given[key]}
    return merged
