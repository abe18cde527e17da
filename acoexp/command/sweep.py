"""A sweep under way: how far it is, whichever launcher runs its jobs, and its table at the end."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from acoexp.command import outcome, summary

_LOOK_EVERY = 0.2


class _Sweep:
    """Counts finished trials by their files, so it needs no word from where they run."""

    def __init__(
        self, folder: Path, trials: int | None, where: str, there: Sequence[Mapping[str, Any]], found: int
    ) -> None:
        self.folder, self.trials, self.where = folder.absolute(), trials, where
        self.there, self.found = there, found
        self.there_before = outcome.finished(self.folder)
        self.began = time.perf_counter()
        self.stopped = threading.Event()
        self.thread = threading.Thread(target=self._show, daemon=True)
        self.thread.start()

    def _show(self) -> None:
        columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
        console = Console(file=sys.stderr)
        with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
            task = progress.add_task("trials", total=self.trials)
            while not self.stopped.wait(_LOOK_EVERY) and console.is_terminal:
                done = outcome.trials_done(self.folder, self.finished())
                progress.update(task, completed=self.found + done)

    def finished(self) -> list[Path]:
        """Return the records written since the sweep began; its folder may have been used before."""
        now = outcome.finished(self.folder)
        return [file for file, time in now.items() if self.there_before.get(file) != time]

    def end(self) -> None:
        self.stopped.set()
        self.thread.join()
        seconds = time.perf_counter() - self.began
        records = [outcome.read(file) for file in self.finished()]
        ran = sum(record.get("ran", 1) for record in records) + outcome.in_progress(self.folder, finished=False)
        found = self.found + sum(record["trials"] - record["ran"] for record in records if "ran" in record)
        of_all = "" if self.trials is None else f" of {self.trials}"
        ended = f"{ran}{of_all} trials finished in {seconds:.1f} s"
        if found:
            ended += f", {found} found in the store"
        summary.print_sweep([*self.there, *records], self.folder, self.where, ended)


_current: list[_Sweep] = []


def begin(
    folder: Path, trials: int | None, where: str, there: Sequence[Mapping[str, Any]] = (), found: int = 0
) -> None:
    """Begin to watch a sweep.

    Args:
        folder: Where its jobs' folders appear.
        trials: How many trials it is, or None if nobody knows.
        where: Where its results go.
        there: Records of what was found in the store.
        found: How many trials these are.
    """
    _current.append(_Sweep(folder, trials, where, there, found))


def finish() -> None:
    """Stop watching and print the table; does nothing if no sweep is under way."""
    while _current:
        _current.pop().end()
