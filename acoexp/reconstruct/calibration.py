"""The command's settings, and what it does with them: one search per seed, each ending in a map file."""

from __future__ import annotations

import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from acoexp.console.whole import write_whole
from acoexp.errors import AcoexpError, SettingsError
from acoexp.grid.grid import Grid
from acoexp.parameters import parameter
from acoexp.reconstruct.fit import Fit
from acoexp.reconstruct.layout import Layout, paint
from acoexp.reconstruct.mapfile import map_text, read_layout
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import CYCLES, ENVIRONMENTS, RULES
from acoexp.reconstruct.screen import SIZE
from acoexp.reconstruct.search import SEARCH_CYCLES, Search
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

FRESH_SEEDS = range(1000)
"""Seeds of the trials by which a map's fit is reported; the search draws all of its own from above them."""


def standard_aco(cycles: int) -> Solver:
    """Return a solver of standard ACO with the paper's settings; on an empty map, until it is put on another."""
    return Solver(Grid(np.zeros((SIZE, SIZE))), resolve("aco", {"iterations": cycles}))


@dataclass(frozen=True, kw_only=True)
class Calibration:
    """A search for maps."""

    env: str = parameter("fig13", "environment of the paper to be reconstructed", choices=tuple(ENVIRONMENTS))
    seed: int = parameter(0, "seed of the first run", minimum=0, maximum=999_999)
    runs: int = parameter(1, "runs, each from a seed of its own: seed, seed + 1, ...", minimum=1, maximum=10_000)
    steps: int = parameter(3000, "candidates that a run lets ants walk on", minimum=1, maximum=999_999)
    moves: str | None = parameter(None, "rule for diagonals; by default the runs take turns", choices=RULES)
    begin: str | None = parameter(None, "map file of an earlier run to go on from; its rule is kept")
    threads: int = parameter(1, "runs at a time; the maps do not depend on it", minimum=1, maximum=1024)
    out: str = parameter("outputs/maps", "folder for the map files")

    def search(self, seed: int, progress: Callable[[], None] = lambda: None) -> str:
        """Return the map file's text that one seed leads to."""
        environment = ENVIRONMENTS[self.env]
        begin, moves = self._beginning()
        search = Search(environment, seed, moves, standard_aco(SEARCH_CYCLES))
        layout = search.run(self.steps, progress, begin)
        aco = standard_aco(CYCLES).on(Grid(paint(layout), moves=search.moves))
        fit = Fit.of(environment, Outcomes.of(result.curve_pairs for result in aco.trials(FRESH_SEEDS)))
        command = f"python -m acoexp.reconstruct env={self.env} seed={seed} steps={self.steps}"
        command += "".join(f" {key}={getattr(self, key)}" for key in ("moves", "begin") if getattr(self, key))
        return map_text(layout, search.moves, environment, fit, command)

    def _beginning(self) -> tuple[Layout | None, str | None]:
        """Return the layout to go on from, and the rule for diagonals, where they are given."""
        if self.begin is None:
            return None, self.moves
        if self.moves is not None:
            raise SettingsError(
                f"moves: expected nothing beside begin, whose map has its rule; got {self.moves!r}"
            )
        return read_layout(self.begin, ENVIRONMENTS[self.env])

    def run(self) -> list[Path]:
        """Search from every seed, write each map as soon as it is found, and return the files.

        Raises:
            SettingsError: if the map to begin with is none, or the folder cannot be written to.
        """
        folder = Path(self.out)
        files = {seed: folder / f"{self.env}-{seed:02d}.txt" for seed in range(self.seed, self.seed + self.runs)}
        self._beginning()  # so that nothing is written if it is wrong
        _make_folder(folder)
        columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
        console = Console(stderr=True)
        with Progress(*columns, console=console, disable=not console.is_terminal) as shown:
            task = shown.add_task(f"{self.env}: candidates", total=self.runs * self.steps)
            self._search_all(files, lambda: shown.advance(task))
        return list(files.values())

    def _search_all(self, files: dict[int, Path], advance: Callable[[], None]) -> None:
        """Search from every seed; if one search fails, or on Ctrl-C, the others end at their next candidate."""
        stopped = threading.Event()

        def progress() -> None:
            if stopped.is_set():
                raise AcoexpError("the search was stopped")
            advance()

        with ThreadPoolExecutor(self.threads) as pool:
            searches = {pool.submit(self.search, seed, progress): seed for seed in files}
            try:
                for done in as_completed(searches):
                    write_whole(files[searches[done]], done.result())
            except BaseException:
                stopped.set()
                pool.shutdown(wait=False, cancel_futures=True)
                raise


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        raise SettingsError(
            f"out: expected a folder to write to; got {str(folder)!r} ({problem.strerror})"
        ) from problem
