"""A sweep under way: how far it is, whichever launcher runs its jobs, and its table at the end."""

from __future__ import annotations

import sys
import threading
import time
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from acoexp.command import summary

_LOOK_EVERY = 0.2


class _Sweep:
    """Counts finished trials by their files, so it needs no word from where they run."""

    def __init__(self, folder: Path, jobs: int | None, where: str) -> None:
        self.folder, self.jobs, self.where = folder.absolute(), jobs, where
        self.there_before = summary.finished(self.folder)
        self.began = time.perf_counter()
        self.stopped = threading.Event()
        self.thread = threading.Thread(target=self._show, daemon=True)
        self.thread.start()

    def _show(self) -> None:
        columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
        console = Console(file=sys.stderr)
        with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
            task = progress.add_task("trials", total=self.jobs)
            while not self.stopped.wait(_LOOK_EVERY) and console.is_terminal:
                progress.update(task, completed=len(self.finished()))

    def finished(self) -> list[Path]:
        """Return the records written since the sweep began; its folder may have been used before."""
        return [
            file for file, time in summary.finished(self.folder).items() if self.there_before.get(file) != time
        ]

    def end(self) -> None:
        self.stopped.set()
        self.thread.join()
        seconds = time.perf_counter() - self.began
        summary.print_sweep(self.folder, self.finished(), self.jobs, self.where, seconds)


_current: list[_Sweep] = []


def begin(folder: Path, jobs: int | None, where: str) -> None:
    """Begin to watch a sweep of so many jobs (None: nobody knows), whose folders appear under ``folder``."""
    _current.append(_Sweep(folder, jobs, where))


def finish() -> None:
    """Stop watching and print the table; does nothing if no sweep is under way."""
    while _current:
        _current.pop().end()
