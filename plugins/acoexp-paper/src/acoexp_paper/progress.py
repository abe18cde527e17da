"""Progress on the terminal: which cell runs, how many trials are done; nothing where there is no terminal."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import Progress, SpinnerColumn, TextColumn, TimeElapsedColumn


@contextmanager
def shown_progress() -> Iterator[Callable[[str, int], None]]:
    """Give what is to be called with a cell's name and its number of finished trials."""
    console = Console(stderr=True)
    columns = (SpinnerColumn(), TextColumn("{task.description}"), TimeElapsedColumn())
    counted: dict[str, int] = {}
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as progress:
        task = progress.add_task("report=paper", total=None)

        def tell(cell: str, done: int) -> None:
            counted[cell] = max(done, counted.get(cell, 0))
            progress.update(task, description=f"{cell}: {done} trials ({sum(counted.values())} in all)")

        yield tell
