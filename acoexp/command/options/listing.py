"""``--info strategies``: every part that is installed, with its package, version, contract and parameters."""

from __future__ import annotations

from acoexp.console.parameters import described_parameters
from acoexp.console.plain import one_line
from acoexp.errors import AcoexpError
from acoexp.registry.entries import GROUPS, clash, entries, misplaced_entries, package_named, part_names
from acoexp.registry.folders import missing_folders
from acoexp.registry.parts import find_part
from acoexp.registry.presets import find_preset, preset_names, preset_package
from acoexp.strategies.part import CONTRACT


def parts_text() -> str:
    """Return the list as plain text: a section a group, a line a part, a line a parameter."""
    version = package_named(entries("diffusion")["none"])
    text = "\n\n".join([f"{version}, contract {CONTRACT}", _presets(), *map(_group, GROUPS)])
    broken = [line.partition("BROKEN: ")[2] for line in text.splitlines() if "BROKEN: " in line]
    broken += [described for _, described in misplaced_entries()] + missing_folders()
    return (
        "\n".join([text, "", "== broken ==", *(f"BROKEN: {described}" for described in broken)])
        if broken
        else text
    )


def _presets() -> str:
    return "\n".join(["== algo ==", *map(_preset, preset_names())])


def _preset(name: str) -> str:
    try:
        parts = find_preset(name).parts
    except AcoexpError as problem:
        return f"{name}  BROKEN: {one_line(str(problem))}"
    return f"{name}  package {preset_package(name)}: " + " ".join(f"{g}={part}" for g, part in parts.items())


def _group(group: str) -> str:
    return "\n".join([f"== {group} ==", *(line for name in part_names(group) for line in _part(group, name))])


def _part(group: str, name: str) -> list[str]:
    entry = entries(group)[name]
    try:
        owner = find_part(group, name)
        parameters = described_parameters(owner, f"{group}.")
    except AcoexpError as problem:
        return [f"{name}  BROKEN: {one_line(str(problem))}"]
    contract = f", contract {owner.contract}" if hasattr(owner, "contract") else ""
    head = f"{name}  package {package_named(entry)}{contract}, {entry.value}"
    clashing = clash(group, name)
    return [
        head,
        *([f"    BROKEN: {clashing}"] if clashing else []),
        *(f"    {key}  {text}" for key, text in parameters.items()),
    ]
