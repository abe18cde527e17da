"""Settings: everything about a trial but its map and its seed, checked."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

from acoexp.colony.scalars import ColonySettings
from acoexp.grid.field import FieldSettings
from acoexp.parameters import values_of


class Chosen(NamedTuple):
    """A part, and where it comes from.

    Attributes:
        name: As it is registered, or its class's name if it is not.
        package: The package that registers it, with its version; None for a part made on the spot.
        part: The part.
    """

    name: str
    package: str | None
    part: Any


@dataclass(frozen=True)
class Settings:
    """What a trial is of.

    Attributes:
        label: The preset's name, or ``custom`` where one of its parts was replaced.
        scalars: The colony's scalars.
        field: The potential field's constants.
        chosen: The part of each strategy group.
    """

    label: str
    scalars: ColonySettings
    field: FieldSettings
    chosen: dict[str, Chosen]

    @cached_property
    def parts(self) -> dict[str, Any]:
        """The parts alone, by group."""
        return {group: chosen.part for group, chosen in self.chosen.items()}

    @property
    def packages(self) -> dict[str, str]:
        """The package of each part that has one, by group."""
        return {group: chosen.package for group, chosen in self.chosen.items() if chosen.package is not None}

    def describe(self, group: str) -> str:
        """Return the words for a part, such as ``diffusion 'shy' of package acoexp-shy 1.0``."""
        chosen = self.chosen[group]
        return f"{group} {chosen.name!r}" + (f" of package {chosen.package}" if chosen.package else "")

    def as_dict(self) -> dict[str, Any]:
        """Return everything as plain values, nested as on the command line: ``diffusion.gamma`` and so on."""
        parts = {group: {"name": chosen.name, **values_of(chosen.part)} for group, chosen in self.chosen.items()}
        return {"algo": self.label, **values_of(self.scalars), "field": values_of(self.field), **parts}
