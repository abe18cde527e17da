"""Recordings: trials whose cycles were recorded, and which show themselves on a page."""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoexp.api import Options
from acoexp.console.whole import write_whole
from acoexp.grid.grid import Cell, Grid
from acoexp.registry.load_map import as_grid
from acoexp.registry.resolve import resolve
from acoexp.trial.recorder import Recorder
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver
from acoexp.watch.cycles import Cycles
from acoexp.watch.packing import packed
from acoexp.watch.page import framed, page_of


class Recording(Cycles):
    """One trial, cycle by cycle; shown in a notebook it is the page that plays it."""

    def pheromone_on_edges(self, cycle: int) -> NDArray[np.float64]:
        """Return the pheromone on each move from each cell after a cycle, float64[rows, cols, 8].

        The trial is run again up to there: see :func:`acoexp.trial.solver.Solver.pheromone`.

        Raises:
            SettingsError: if the cycle is not a whole number from 1 to the number of cycles.
        """
        scalars = replace(self.settings.scalars, iterations=self.checked(cycle))
        return Solver(self.grid, replace(self.settings, scalars=scalars)).pheromone(self.result.seed)

    def save(self, path: str | PathLike[str]) -> None:
        """Write the page that plays the recording, one HTML file that needs no other.

        Raises:
            SettingsError: if the page would be too large.
            OSError: if it cannot be written.
        """
        write_whole(Path(path), self._page)

    def _repr_html_(self) -> str:
        return framed(self._page)

    @cached_property
    def _page(self) -> str:
        return page_of([packed(self.result.algo, self)])


def record(
    map: str | Path | Grid | ArrayLike,
    algo: str = "pdg",
    seed: int = 0,
    *,
    start: Cell | None = None,
    goal: Cell | None = None,
    moves: str | None = None,
    **settings: Unpack[Options],
) -> Recording:
    """Run one trial and record every cycle; the arguments are those of :func:`acoexp.solve`.

    It takes four bytes for each cell and cycle, and one for each move that an ant made.

    Raises:
        SettingsError, MapError, StrategyError: As :func:`acoexp.solve`; SettingsError also if there is more to
            record than half a gigabyte of pheromone, or as many moves.
    """
    return recording_of(as_grid(map, start, goal, moves), resolve(algo, settings), seed)


def recording_of(grid: Grid, settings: Settings, seed: int) -> Recording:
    """Run one trial of these settings on a map and record every cycle.

    Raises:
        SettingsError, StrategyError: As :func:`record`.
    """
    recorder = Recorder(grid, settings)
    result, tape = recorder.record(seed)
    return Recording(result, settings, recorder.desirability, tape)
