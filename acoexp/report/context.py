"""What a report is given: the command line's settings and map, a folder, and a way to run trials."""

from __future__ import annotations

import json
import logging
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import datetime
from functools import cached_property
from itertools import count
from pathlib import Path
from typing import Any

from acoexp.console.whole import whole_folder
from acoexp.grid.grid import Grid
from acoexp.parameters import values_of
from acoexp.report.folder import MADE_BY, is_empty, is_made_by, write_mark
from acoexp.trial.seeds import Seeds
from acoexp.trial.settings import Settings
from acoexp.trial.trials import Trials

log = logging.getLogger(__name__)

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
        seed: Its seed, for a report on a single trial.
        folder: Where the report goes, ``outputs/reports/<name>`` unless somebody says otherwise.
        trials_of: Returns the trials of settings on a map with some seeds; they are kept, and what was kept before
            is taken from there.
        show: Called with a configuration's name and its number of finished trials while it runs.
        made_by: All that the report depends on, as plain values; None where nobody asks.
    """

    algo: str
    preset: Settings
    settings: Settings
    grid: Grid
    seed: int = 0
    folder: Path
    trials_of: Callable[[Settings, Grid, Seeds, Count], Trials]
    show: Callable[[str, int], None] = lambda configuration, done: None
    made_by: Mapping[str, Any] | None = None

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

    @contextmanager
    def draft(self) -> Iterator[Path]:
        """Give a folder to write the report to, which then takes the place of ``folder``, whole or not at all.

        A report that is there is kept beside it, under its date, if it was made by other settings or if there is
        anything in its folder that this report did not write.
        """
        keep = self._keep()
        with whole_folder(self.folder, keep) as draft:
            yield draft
            if self.made_by is not None:
                write_mark(draft, self._made_by)
        self._say_what_is_kept(keep)

    @contextmanager
    def place(self) -> Iterator[None]:
        """Make place for a report that is written straight to ``folder``, and mark what was written there.

        What :meth:`draft` would keep beside it is put there before, and back if nothing takes its place.
        """
        keep = self._keep()
        if keep is not None:
            self.folder.rename(keep)
        try:
            yield
        finally:
            if keep is not None and not os.path.lexists(self.folder):
                keep.rename(self.folder)
            else:
                self._say_what_is_kept(keep)
        if self.made_by is not None and self.folder.is_dir() and not is_made_by(self.folder, self._made_by):
            write_mark(self.folder, self._made_by)

    @property
    def _made_by(self) -> Any:
        """Return what it was made by as it is read again."""
        return json.loads(json.dumps(self.made_by, default=str))

    def _keep(self) -> Path | None:
        """Return where what is there is to be kept; None if the report may replace it."""
        mark = self.folder / MADE_BY
        if self.made_by is None or not os.path.lexists(self.folder):
            return None
        if is_empty(self.folder) or is_made_by(self.folder, self._made_by):
            return None
        made = datetime.fromtimestamp((mark if os.path.lexists(mark) else self.folder).lstat().st_mtime)
        name = f"{self.folder.name}-{made:%Y-%m-%d-%H-%M-%S}"
        names = (self.folder.with_name(name if number == 1 else f"{name}-{number}") for number in count(1))
        return next(path for path in names if not os.path.lexists(path))

    def _say_what_is_kept(self, keep: Path | None) -> None:
        if keep is not None:
            said = "the report that was in %s is of other settings, or was changed since, and is kept: %s"
            log.info(said, self.folder, keep)


def _changed(values: Any, defaults: Any) -> dict[str, Any]:
    before = values_of(defaults)
    return {key: value for key, value in values_of(values).items() if value != before[key]}
