"""``--info strategies``: every part that is installed, with its package, version, contract and parameters."""

from __future__ import annotations

from typing import Any

from acoexp import registry
from acoexp.errors import AcoexpError
from acoexp.parameters import fields_of
from acoexp.presets import faults, find_preset, preset_names, preset_package
from acoexp.strategies.part import CONTRACT


def parts_text() -> str:
    """Return the list as plain text: a section a group, a line a part, a line a parameter."""
    version = registry.package_named(registry.entries("diffusion")["none"])
    text = "\n\n".join([f"{version}, contract {CONTRACT}", _presets(), *map(_group, registry.GROUPS)])
    broken = [line.partition("BROKEN: ")[2] for line in text.splitlines() if "BROKEN: " in line]
    broken += [told for _, told in registry.strays()] + faults()
    return "\n".join([text, "", "== broken ==", *(f"BROKEN: {told}" for told in broken)]) if broken else text


def _presets() -> str:
    return "\n".join(["== algo ==", *map(_preset, preset_names())])


def _preset(name: str) -> str:
    try:
        parts = find_preset(name).parts
    except AcoexpError as problem:
        return f"{name}  BROKEN: {problem}"
    return f"{name}  package {preset_package(name)}: " + " ".join(f"{g}={part}" for g, part in parts.items())


def _group(group: str) -> str:
    return "\n".join([f"== {group} ==", *(line for name in registry.names(group) for line in _part(group, name))])


def _part(group: str, name: str) -> list[str]:
    entry = registry.entries(group)[name]
    try:
        owner = registry.find(group, name)
        lines = [f"    {_parameter(group, key, field)}" for key, field in fields_of(owner).items()]
    except AcoexpError as problem:
        return [f"{name}  BROKEN: {problem}"]
    contract = f", contract {owner.contract}" if hasattr(owner, "contract") else ""
    head = f"{name}  package {registry.package_named(entry)}{contract}, {entry.value}"
    clash = registry.clash(group, name)
    return [head, *([f"    BROKEN: {clash}"] if clash else []), *lines]


def _parameter(group: str, key: str, field: Any) -> str:
    default = "null" if field.default is None else field.default
    return f"{group}.{key}={default}  {field.metadata['meaning']}"
