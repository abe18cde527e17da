"""Watching: how far a run of many trials is while its jobs run somewhere, and its table however it ends."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from acoexp.command.results.records import in_progress, read_record, records_below, trials_done
from acoexp.command.results.table import print_sweep

_LOOK_EVERY = 0.2


@dataclass(frozen=True, kw_only=True)
class Watched:
    """What is watched.

    Attributes:
        folder: Where its jobs' folders appear.
        where: Where its results go, for a person.
        trials: How many trials it is; None if nobody knows.
        known: Records of what was found in the store.
        found: How many trials these are.
    """

    folder: Path
    where: str
    trials: int | None = None
    known: Sequence[Mapping[str, Any]] = field(default=())
    found: int = 0


class Watch:
    """Looks after jobs from its making until its end."""

    def __init__(self, watched: Watched) -> None:
        self._watched = watched
        self._before = records_below(watched.folder)  # the folder may have been used before
        self._began = time.perf_counter()
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._show, daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Stop watching and print the table."""
        self._stopped.set()
        self._thread.join()
        watched, seconds = self._watched, time.perf_counter() - self._began
        records = [read_record(file) for file in self._finished()]
        ran = sum(record.get("ran", 1) for record in records) + in_progress(watched.folder, finished=False)
        found = watched.found + sum(record["trials"] - record["ran"] for record in records if "ran" in record)
        of_all = "" if watched.trials is None else f" of {watched.trials}"
        ended = f"{ran}{of_all} trials finished in {seconds:.1f} s"
        if found:
            ended += f", {found} found in the store"
        print_sweep([*watched.known, *records], watched.folder, watched.where, ended)

    def _show(self) -> None:
        columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
        console = Console(file=sys.stderr)
        with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
            task = progress.add_task("trials", total=self._watched.trials)
            while not self._stopped.wait(_LOOK_EVERY) and console.is_terminal:
                done = trials_done(self._watched.folder, self._finished())
                progress.update(task, completed=self._watched.found + done)

    def _finished(self) -> list[Path]:
        """Return the records written since the watch began."""
        now = records_below(self._watched.folder)
        return [file for file, written in now.items() if self._before.get(file) != written]


@contextmanager
def watching(watched: Watched) -> Iterator[None]:
    """Watch over what runs within, and print its table however that ends."""
    watch = Watch(watched)
    try:
        yield
    finally:
        watch.end()
