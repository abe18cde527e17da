"""What a report is given: the command line's settings and map, a folder, and a way to run trials."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from acoexp.grid import Grid
from acoexp.parameters import values_of
from acoexp.seeds import Seeds
from acoexp.settings import Settings, resolve
from acoexp.tracking.kept_batch import keep_batch
from acoexp.tracking.setup import Setup
from acoexp.tracking.tracker import NoTracker, Tracker
from acoexp.trials import Trials


@dataclass(frozen=True)
class Context:
    """What a report works on.

    Attributes:
        algo: The command line's preset.
        settings: Its settings, resolved.
        grid: Its map.
        folder: Where the report goes, ``outputs/reports/<name>``.
        tracker: Where trials are kept, and taken from if they are there.
        threads: How many threads run trials; None for one for each processor.
        resume: Whether trials that the tracker has are taken from there.
        tell: Called with a cell's name and its number of finished trials while it runs.
    """

    algo: str
    settings: Settings
    grid: Grid
    folder: Path
    tracker: Tracker = field(default_factory=NoTracker)
    threads: int | None = None
    resume: bool = True
    tell: Callable[[str, int], None] = lambda cell, done: None

    @cached_property
    def own_settings(self) -> dict[str, Any]:
        """Scalars, and ``field`` as a mapping, in which the command line differs from its preset."""
        scalars = _changed(self.settings.scalars, self._preset.scalars)
        field = _changed(self.settings.field, self._preset.field)
        return {**scalars, "field": field} if field else scalars

    @cached_property
    def own_parts(self) -> list[str]:
        """Groups in which the command line's part differs from its preset's."""
        return [group for group, part in self.settings.parts.items() if part != self._preset.parts[group]]

    @cached_property
    def _preset(self) -> Settings:
        return resolve(self.algo, {})

    def run(self, settings: Settings, grid: Grid, seeds: Seeds, cell: str = "") -> Trials:
        """Return the trials of a configuration on a map, in the order of their seeds.

        They are kept as a batch; what is there is taken from there.

        Args:
            settings: The configuration.
            grid: The map.
            seeds: The seeds.
            cell: What the cell is called while its progress is shown.

        Raises:
            StrategyError: if a trial failed.
        """
        portions: list[Trials] = []
        batch = keep_batch(
            Setup.of(settings, grid),
            seeds,
            self.tracker,
            threads=self.threads,
            resume=self.resume,
            receive=portions.append,
            tell=lambda done: self.tell(cell or settings.label, done),
        )
        for failure in batch.failures:
            raise failure.reason
        return Trials.joined(portions)


def _changed(values: Any, defaults: Any) -> dict[str, Any]:
    before = values_of(defaults)
    return {key: value for key, value in values_of(values).items() if value != before[key]}
