"""What a tracker is, and which one a configuration asks for."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, Protocol

from acoexp.errors import SettingsError
from acoexp.parameters import REQUIRED
from acoexp.seeds import Seeds
from acoexp.tracking.setup import Setup, Trial
from acoexp.trials import Aggregates, Trials

_IN_MEMORY = re.compile(r"^sqlite[^:]*:/*(\?|$)|:memory:|mode=memory")


class Found(NamedTuple):
    """A finished run that is in the store: a trial or a batch.

    Attributes:
        trials: How many trials it is of.
        metrics: Its metrics, by name.
        params: Its configuration, flattened.
    """

    trials: int
    metrics: Mapping[str, float]
    params: Mapping[str, str]


class BatchLog(Protocol):
    """A batch that is being kept."""

    def keep(self, portion: Trials) -> None:
        """Keep a portion of finished trials, for good."""

    def finish(
        self, summary: Aggregates | None, curve: Any, table: Iterable[str], failed: Mapping[int, str]
    ) -> None:
        """Keep the aggregates and the table, and say that the batch has ended.

        Args:
            summary: The aggregates of all finished trials; None if there is none.
            curve: Mean of the best length found in each cycle, float[iterations].
            table: The lines of the table of trials.
            failed: Why trials failed, by their seed; a batch with any has failed.
        """

    def abandon(self, reason: str) -> None:
        """Say at once, if it can be said, that the batch will not be finished; what was kept stays."""


class Tracker(Protocol):
    """Keeps finished trials."""

    where: str
    """What to tell a person about where results lie."""

    def prepare(self) -> None:
        """Create the store if it is not there, and close what killed processes left open; before any trial.

        Raises:
            TrackingError: if it cannot be reached or written.
        """

    def find(self, cell: str) -> dict[str, Found]:
        """Return the finished runs of a cell, each under its identity."""

    def has(self, identity: str) -> bool:
        """Tell whether there is a finished run of an identity."""

    def find_trials(self, cell: str, seeds: Seeds) -> Iterable[Trials]:
        """Yield trials of a cell that were kept in batches, finished or not, each at most once."""

    def log(self, trial: Trial, *, anew: bool = False) -> None:
        """Keep one trial, whole or not at all.

        Args:
            trial: The trial.
            anew: Whether it takes the place of the same trial that is there, instead of leaving it.

        Raises:
            TrackingError: if it cannot be kept.
        """

    def log_failure(self, setup: Setup, seed: int, reason: str) -> None:
        """Keep that a trial failed, and why."""

    def begin(self, setup: Setup, seeds: Seeds, *, anew: bool = False) -> BatchLog:
        """Begin to keep a batch."""


class NoTracker:
    """``tracking=none``: keeps nothing."""

    where = "not tracked"

    def prepare(self) -> None:
        """Do nothing."""

    def find(self, cell: str) -> dict[str, Found]:
        """Find nothing."""
        return {}

    def has(self, identity: str) -> bool:
        """Say no."""
        return False

    def find_trials(self, cell: str, seeds: Seeds) -> Iterable[Trials]:
        """Find nothing."""
        return ()

    def log(self, trial: Trial, *, anew: bool = False) -> None:
        """Do nothing."""

    def log_failure(self, setup: Setup, seed: int, reason: str) -> None:
        """Do nothing."""

    def begin(self, setup: Setup, seeds: Seeds, *, anew: bool = False) -> BatchLog:
        """Return a log that keeps nothing."""
        return _NoLog()


class _NoLog:
    def keep(self, portion: Trials) -> None:
        pass

    def finish(
        self, summary: Aggregates | None, curve: Any, table: Iterable[str], failed: Mapping[int, str]
    ) -> None:
        pass

    def abandon(self, reason: str) -> None:
        pass


def open_tracker(config: Mapping[str, Any]) -> Tracker:
    """Return the tracker for the ``tracking`` part of a configuration; nothing is imported or touched yet.

    Raises:
        SettingsError: if its name is unknown, a key is, or the address is not a text.
    """
    from acoexp.tracking.mlflow_tracker import MlflowTracker

    allowed = {"none": {"name"}, "mlflow": {"name", "uri"}}
    name = config.get("name")
    if name not in allowed:
        raise SettingsError(f"tracking: expected one of: {', '.join(sorted(allowed))}; got {name!r}")
    for key in config.keys() - allowed[name]:
        raise SettingsError(f"tracking.{key} is not a known key of tracking={name}")
    if name == "none":
        return NoTracker()
    return MlflowTracker(check_uri(config.get("uri")))


def check_uri(uri: Any) -> str:
    """Return the address of a store that lasts.

    Raises:
        SettingsError: if it is none.
    """
    if not isinstance(uri, str) or uri in ("", REQUIRED) or _IN_MEMORY.search(uri):
        raise SettingsError(f"tracking.uri: expected the address of an MLflow store that lasts; got {uri!r}")
    return uri
