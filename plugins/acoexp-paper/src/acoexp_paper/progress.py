"""Progress on the terminal: which cell runs, and how many trials are done; nothing where there is no terminal."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

_A_LINE_PER_BATCH = logging.getLogger("acoexp.tracking.kept_batch")


@contextmanager
def shown_progress(trials: int) -> Iterator[Callable[[str, int], None]]:
    """Give what is to be called with a batch's name and its number of finished trials.

    Args:
        trials: How many there will be in all batches.
    """
    console = Console(stderr=True)
    columns = (
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("trials"),
        TimeElapsedColumn(),
        TextColumn("{task.description}"),
    )
    finished: dict[str, int] = {}
    level = _A_LINE_PER_BATCH.level
    _A_LINE_PER_BATCH.setLevel(logging.WARNING)  # hundreds of them
    try:
        with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
            task = progress.add_task("", total=trials)

            def tell(batch: str, done: int) -> None:
                finished[batch] = done
                progress.update(task, completed=sum(finished.values()), description=batch)

            yield tell
    finally:
        _A_LINE_PER_BATCH.setLevel(level)
