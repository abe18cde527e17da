"""What a report is given: the command line's settings and map, a folder, and a way to run trials."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from acoexp.grid import Grid
from acoexp.result import Result
from acoexp.settings import Settings, resolve
from acoexp.solver import Solver


@dataclass(frozen=True)
class Context:
    """What a report works on.

    Attributes:
        algo: The command line's preset.
        settings: Its settings, resolved.
        grid: Its map.
        folder: Where the report goes, ``outputs/reports/<name>``.
    """

    algo: str
    settings: Settings
    grid: Grid
    folder: Path

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

    def run(self, settings: Settings, grid: Grid, seeds: Iterable[int]) -> list[Result]:
        """Run one trial per seed on all processors; results stand in the order of the seeds."""
        return Solver(grid, settings).solve_many(seeds)


def _changed(values: Any, defaults: Any) -> dict[str, Any]:
    before = asdict(defaults)
    return {key: value for key, value in asdict(values).items() if value != before[key]}
