"""What is tracked: a configuration on a map, and a trial of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from acoexp.grid import Grid
from acoexp.identity import cell_identity, trial_identity
from acoexp.result import Result
from acoexp.settings import Settings

NOT_OF_THE_TRIAL = ("tracking", "report", "seeds", "threads", "resume")
"""Keys on which no result depends; an address may also hold a password."""


@dataclass(frozen=True)
class Setup:
    """A configuration on a map: what trials that differ by their seed alone have in common.

    Attributes:
        settings: The settings, resolved.
        grid: The map.
        config: The configuration that they came from, nested; what a person looks for in the store.
    """

    settings: Settings
    grid: Grid
    config: Mapping[str, Any]

    @classmethod
    def of(cls, settings: Settings, grid: Grid) -> Setup:
        """Return the setup for settings and a map that came from no configuration."""
        return cls(settings, grid, {**settings.as_dict(), "map": {"name": grid.name}})

    @cached_property
    def params(self) -> dict[str, str]:
        """The configuration without its seed, flattened: ``diffusion.gamma`` and so on, in order."""
        left_out = {*NOT_OF_THE_TRIAL, "seed"}
        return {
            **dict(flatten({key: value for key, value in self.config.items() if key not in left_out})),
            "algo": self.settings.label,
        }

    @cached_property
    def cell(self) -> str:
        """The identity of all its trials together."""
        return cell_identity(self.settings, self.grid)

    def identity(self, seeds: object) -> str:
        """Return the identity of the trial with a seed, or of the batch with some seeds."""
        return trial_identity(self.cell, seeds)


@dataclass(frozen=True)
class Trial:
    """A finished trial.

    Attributes:
        setup: What it is a trial of.
        result: What it found.
    """

    setup: Setup
    result: Result

    @property
    def params(self) -> dict[str, str]:
        """The configuration, flattened."""
        return {**self.setup.params, "seed": str(self.result.seed)}

    @property
    def identity(self) -> str:
        """What tells it from every other trial."""
        return self.setup.identity(self.result.seed)


def flatten(config: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, str]]:
    """Yield ``(dotted key, value as text)`` for every leaf of a nested configuration."""
    for key, value in config.items():
        if isinstance(value, Mapping):
            yield from flatten(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", str(value)
