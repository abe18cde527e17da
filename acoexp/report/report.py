"""What a report is: a few parameters, and a folder that it writes."""

from __future__ import annotations

import os
import shutil
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from acoexp.report.context import Context


class Report(ABC):
    """One report; subclasses are frozen dataclasses whose fields are their parameters."""

    def check(self, context: Context) -> None:  # noqa: B027, as a report may have nothing to refuse
        """Refuse what could not be written; called before anything runs.

        Raises:
            AcoexpError: if so.
        """

    @abstractmethod
    def write(self, context: Context) -> Path:
        """Run what is needed, write the report, and return its folder: ``context.folder``.

        Raises:
            AcoexpError: for whatever went wrong.
        """

    def headline(self, folder: Path) -> Sequence[Sequence[str]]:
        """Return a short table of what the written report says: its headings, then its rows."""
        return []


@contextmanager
def written_whole(folder: Path) -> Iterator[Path]:
    """Give a draft folder to write to, which then replaces ``folder``; after an error nothing has changed."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    draft, old = (folder.with_name(f".{folder.name}-{os.getpid()}-{what}") for what in ("draft", "old"))
    shutil.rmtree(draft, ignore_errors=True)  # of a process that had this number and was killed
    draft.mkdir()
    try:
        yield draft
        if folder.exists():
            folder.replace(old)
        draft.replace(folder)
    finally:
        if old.exists() and not folder.exists():
            old.replace(folder)
        shutil.rmtree(draft, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)
