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

    def __init__(self, folder: Path, jobs: int, where: str) -> None:
        self.folder, self.jobs, self.where = folder.absolute(), jobs, where
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
                progress.update(task, completed=len(summary.finished(self.folder)))

    def end(self) -> None:
        self.stopped.set()
        self.thread.join()
        summary.print_sweep(self.folder, self.jobs, self.where, time.perf_counter() - self.began)


_current: list[_Sweep] = []


def begin(folder: Path, jobs: int, where: str) -> None:
    """Begin to watch a sweep of so many jobs, whose folders appear under ``folder``."""
    _current.append(_Sweep(folder, jobs, where))


def finish() -> None:
    """Stop watching and print the table; does nothing if no sweep is under way."""
    while _current:
        _current.pop().end()
