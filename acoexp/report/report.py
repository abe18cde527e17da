"""What a report is: a few parameters, and a folder that it writes."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from pathlib import Path

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
