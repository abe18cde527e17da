"""What a report is given: the command line's settings and map, a folder, and a way to run trials."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from acoexp.grid.grid import Grid
from acoexp.parameters import values_of
from acoexp.trial.seeds import Seeds
from acoexp.trial.settings import Settings
from acoexp.trial.trials import Trials

Count = Callable[[int], None]
"""Called with the number of trials that are finished, now and then."""


@dataclass(frozen=True, kw_only=True)
class Context:
    """What a report works on.

    Attributes:
        algo: The command line's preset.
        preset: That preset's settings, when nothing else is said.
        settings: The command line's settings, resolved.
        grid: Its map.
        folder: Where the report goes, ``outputs/reports/<name>``.
        trials_of: Returns the trials of settings on a map with some seeds; they are kept, and what was kept before
            is taken from there.
        show: Called with a configuration's name and its number of finished trials while it runs.
    """

    algo: str
    preset: Settings
    settings: Settings
    grid: Grid
    folder: Path
    trials_of: Callable[[Settings, Grid, Seeds, Count], Trials]
    show: Callable[[str, int], None] = lambda configuration, done: None

    @cached_property
    def own_settings(self) -> dict[str, Any]:
        """Scalars, and ``field`` as a mapping, in which the command line differs from its preset."""
        scalars = _changed(self.settings.scalars, self.preset.scalars)
        field = _changed(self.settings.field, self.preset.field)
        return {**scalars, "field": field} if field else scalars

    @cached_property
    def own_parts(self) -> list[str]:
        """Groups in which the command line's part differs from its preset's."""
        return [group for group, part in self.settings.parts.items() if part != self.preset.parts[group]]

    def run(self, settings: Settings, grid: Grid, seeds: Seeds, configuration: str = "") -> Trials:
        """Return the trials of a configuration on a map, in the order of their seeds.

        Args:
            settings: The configuration.
            grid: The map.
            seeds: The seeds.
            configuration: What it is called while its progress is shown.

        Raises:
            StrategyError: if a trial failed.
        """
        name = configuration or settings.label
        return self.trials_of(settings, grid, seeds, lambda done: self.show(name, done))


def _changed(values: Any, defaults: Any) -> dict[str, Any]:
    before = values_of(defaults)
    return {key: value for key, value in values_of(values).items() if value != before[key]}
