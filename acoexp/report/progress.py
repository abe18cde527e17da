"""Progress on the terminal: which batch runs, and how many trials are done; nothing where there is no terminal."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn


@contextmanager
def shown_progress(trials: int) -> Iterator[Callable[[str, int], None]]:
    """Give what is to be called with a batch's name and its number of finished trials.

    Args:
        trials: How many there will be in all batches.
    """
    console = Console(stderr=True)
    columns = BarColumn(), MofNCompleteColumn(), TextColumn("trials"), TimeElapsedColumn()
    finished: dict[str, int] = {}
    display = Progress(
        *columns,
        TextColumn("{task.description}", markup=False),
        console=console,
        transient=True,
        disable=not console.is_terminal,
    )
    with _no_line_per_batch(), display as progress:
        task = progress.add_task("", total=trials)

        def show(batch: str, done: int) -> None:
            finished[batch] = done
            progress.update(task, completed=sum(finished.values()), description=batch)

        yield show


@contextmanager
def _no_line_per_batch() -> Iterator[None]:
    """Keep the log's lines off the terminal: a report runs hundreds of batches."""
    log = logging.getLogger("acoexp.runs.batch")
    level = log.level
    log.setLevel(logging.WARNING)
    try:
        yield
    finally:
        log.setLevel(level)
