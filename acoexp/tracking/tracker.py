"""What a tracker is: it keeps finished trials, and finds them again."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Protocol

from acoexp.tracking.setup import Artifacts, Found, Setup, Trial
from acoexp.trial.outcome import Batch
from acoexp.trial.seeds import Seeds
from acoexp.trial.trials import Trials


class BatchLog(Protocol):
    """A batch that is being kept."""

    def keep(self, portion: Trials) -> None:
        """Keep a portion of finished trials, for good."""

    def finish(self, batch: Batch, artifacts: Artifacts) -> None:
        """Keep the aggregates and the table, and say that the batch has ended; one with failures has failed.

        Args:
            batch: All of it.
            artifacts: What its run carries of its best trial.
        """

    def abandon(self, reason: str) -> None:
        """Say at once, if it can be said, that the batch will not be finished; what was kept stays."""


class Tracker(Protocol):
    """Keeps finished trials."""

    where: str
    """Where results lie, for a person."""

    @property
    def address(self) -> str | None:
        """The absolute address of the store, for a worker; None if there is no store."""

    def check(self) -> None:
        """Refuse a store that a quick look shows cannot be written; it need not be made ready for that.

        Raises:
            TrackingError: if it is one.
        """

    def prepare(self) -> None:
        """Create the store if it is not there, and close what killed processes left open; before any trial.

        Raises:
            TrackingError: if it cannot be reached or written.
        """

    def find(self, configuration_id: str, identities: Collection[str]) -> dict[str, Found]:
        """Return the finished runs of a configuration that are of some identities, each under its own."""

    def has(self, identity: str) -> bool:
        """Tell whether there is a finished run of an identity."""

    def has_all(self, identities: Collection[str]) -> bool:
        """Tell whether a quick look, before the store is made ready, shows a finished run of each identity."""

    def find_trials(self, configuration_id: str, seeds: Seeds) -> Iterable[Trials]:
        """Yield trials of a configuration that were kept in batches, finished or not, each at most once."""

    def log(self, trial: Trial, *, resume: bool = True) -> None:
        """Keep one trial, whole or not at all.

        Args:
            trial: The trial.
            resume: Whether the same trial, if it is there, stays; otherwise this one takes its place.

        Raises:
            TrackingError: if it cannot be kept.
        """

    def log_failure(self, setup: Setup, seed: int, reason: str) -> None:
        """Keep that a trial failed, and why."""

    def begin(self, setup: Setup, seeds: Seeds, *, resume: bool = True) -> BatchLog:
        """Begin to keep a batch."""


class NoTracker:
    """``tracking=none``: keeps nothing."""

    where = "not tracked"
    address: str | None = None

    def check(self) -> None:
        """Do nothing."""

    def prepare(self) -> None:
        """Do nothing."""

    def find(self, configuration_id: str, identities: Collection[str]) -> dict[str, Found]:
        """Find nothing."""
        return {}

    def has(self, identity: str) -> bool:
        """Say no."""
        return False

    def has_all(self, identities: Collection[str]) -> bool:
        """Say no."""
        return False

    def find_trials(self, configuration_id: str, seeds: Seeds) -> Iterable[Trials]:
        """Find nothing."""
        return ()

    def log(self, trial: Trial, *, resume: bool = True) -> None:
        """Do nothing."""

    def log_failure(self, setup: Setup, seed: int, reason: str) -> None:
        """Do nothing."""

    def begin(self, setup: Setup, seeds: Seeds, *, resume: bool = True) -> BatchLog:
        """Return a log that keeps nothing."""
        return _NoLog()


class _NoLog:
    def keep(self, portion: Trials) -> None:
        pass

    def finish(self, batch: Batch, artifacts: Artifacts) -> None:
        pass

    def abandon(self, reason: str) -> None:
        pass
