"""What is tracked: a configuration on a map, a trial of it, and a run that is found again."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

from acoexp.grid.grid import Grid
from acoexp.tracking.identity import configuration_id, trial_identity
from acoexp.trial.result import Result
from acoexp.trial.settings import Settings

Artifacts = Mapping[str, bytes]
"""Files that a run carries: what is in each, by its name."""


@dataclass(frozen=True)
class Setup:
    """A configuration on a map: what trials that differ by their seed alone have in common.

    Attributes:
        settings: The settings, resolved.
        grid: The map.
        map: Name and parameters of the source that the map came from.
        command: The command that runs it again, for a person; None where it was none.
    """

    settings: Settings
    grid: Grid
    map: Mapping[str, Any]
    command: str | None = None

    @classmethod
    def of(cls, settings: Settings, grid: Grid) -> Setup:
        """Return the setup for settings and a map that came from no source."""
        return cls(settings, grid, {"name": grid.name})

    @cached_property
    def params(self) -> dict[str, str]:
        """The resolved settings and the map, flattened: ``diffusion.gamma`` and so on."""
        return dict(flatten({**self.settings.as_dict(), "map": self.map}))

    @cached_property
    def configuration_id(self) -> str:
        """The identity of all its trials together."""
        return configuration_id(self.settings.as_dict(), self.settings.parts.values(), self.grid)

    def identity(self, seeds: object) -> str:
        """Return the identity of the trial with a seed, or of the batch with some seeds."""
        return trial_identity(self.configuration_id, seeds)


@dataclass(frozen=True)
class Trial:
    """A finished trial.

    Attributes:
        setup: What it is a trial of.
        result: What it found.
        seconds: Time that it took.
        artifacts: What its run carries.
    """

    setup: Setup
    result: Result
    seconds: float = math.nan
    artifacts: Artifacts = field(default_factory=dict)

    @property
    def params(self) -> dict[str, str]:
        """The configuration, flattened."""
        return {**self.setup.params, "seed": str(self.result.seed)}

    @property
    def identity(self) -> str:
        """What tells it from every other trial."""
        return self.setup.identity(self.result.seed)


class Found(NamedTuple):
    """A finished run that is in the store: a trial or a batch.

    Attributes:
        kind: ``trial`` or ``batch``.
        trials: How many trials it is of.
        metrics: Its metrics, by name; a finished run has all that its kind needs.
    """

    kind: str
    trials: int
    metrics: Mapping[str, float]


def flatten(config: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, str]]:
    """Yield ``(dotted key, value as text)`` for every leaf of a nested configuration."""
    for key, value in config.items():
        if isinstance(value, Mapping):
            yield from flatten(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", str(list(value) if isinstance(value, tuple) else value)
