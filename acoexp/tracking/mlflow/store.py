"""An MLflow store at an address: made ready once, then asked again and again while it is away.

mlflow takes over a second to import, so it is imported when the store is touched and not before.
"""

from __future__ import annotations

import logging
import os
import re
import sqlite3
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from filelock import FileLock

from acoexp.errors import StoreGoneError, TrackingError

if TYPE_CHECKING:
    from mlflow import MlflowClient
    from mlflow.entities import Run

log = logging.getLogger(__name__)

EXPERIMENT = "acoexp"
PATIENCE = 90.0
"""Seconds for which a store may be away before a trial is given up."""

_SQLITE = "sqlite:///"
_PAGE = 1000
_MLFLOW_SETTINGS = {
    "MLFLOW_ENABLE_ARTIFACTS_PROGRESS_BAR": "false",
    "MLFLOW_HTTP_REQUEST_MAX_RETRIES": "2",  # how long to wait for a server that is away is our decision
}
_LOCK = 0x61636F657870  # "acoexp"
_T = TypeVar("_T")


class Store:
    """An MLflow store.

    Attributes:
        uri: Its address.
        file: Its database file, if it is one of SQLite's.
        folder: Where that lies.
        shown: The address as it may be shown, without a password.
    """

    def __init__(self, uri: str) -> None:
        file, mark, query = uri.removeprefix(_SQLITE).partition("?")
        self.file = Path(file).absolute() if uri.startswith(_SQLITE) else None
        self.uri = uri if self.file is None else f"{_SQLITE}{self.file}{mark}{query}"
        self.folder = None if self.file is None else self.file.parent
        self.shown = re.sub(r"//[^/@]*@", "//***@", uri)  # no password on a screen or in a log
        self._is_gone = False  # patience ran out once: nobody waits for it again

    def prepare(self) -> None:
        """Create the store and the experiment if they are not there.

        Raises:
            TrackingError: if the store cannot be reached or written.
        """
        self._is_gone = False
        self.__dict__.pop("experiment_id", None)  # the store that was there before may have been another
        with self._reporting("cannot be opened"):
            if self.file is not None:
                self.file.parent.mkdir(parents=True, exist_ok=True)
            with self._alone():
                if self.file is not None:
                    _check_writable(self.file)
                experiment = self.client.get_experiment_by_name(EXPERIMENT)
                if experiment is None:
                    self.client.create_experiment(EXPERIMENT, self._artifacts())
                elif experiment.lifecycle_stage != "active":
                    self.client.restore_experiment(experiment.experiment_id)

    def with_retries(self, action: Callable[[], _T], what: str) -> _T:
        """Do something with the store, again and again while it is away.

        Args:
            action: What to do; it may be done more than once.
            what: What is said of the store if it fails, such as ``does not take a trial``.

        Raises:
            TrackingError: if it fails for good.
            StoreGoneError: if the store stays away.
        """
        began, pause, warned = time.monotonic(), 0.1, False
        with self._reporting(what):
            while True:
                try:
                    return action()
                except Exception as problem:
                    waited = time.monotonic() - began
                    if not _may_pass(problem) or self._is_gone:
                        raise
                    if waited + pause > PATIENCE:
                        self._is_gone = True
                        raise StoreGoneError(
                            f"tracking.uri: {self.shown} {what} for {PATIENCE:.0f} s: {_reason(problem)}"
                        ) from problem
                    if not warned:
                        warned = True
                        log.warning("%s %s; trying again for %.0f s", self.shown, what, PATIENCE)
                    time.sleep(pause)
                    pause = min(2.0 * pause, 5.0)

    def search(self, condition: str) -> list[Run]:
        """Return all runs of the experiment that meet a condition in MLflow's language, the oldest first."""
        runs: list[Run] = []
        token = None
        while True:
            page = self.client.search_runs(
                [self.experiment_id], condition, 1, _PAGE, ["attributes.start_time ASC"], token
            )
            runs.extend(page)
            token = page.token
            if not token:
                return runs

    @cached_property
    def client(self) -> MlflowClient:
        """MLflow's client for this store."""
        for key, value in _MLFLOW_SETTINGS.items():
            os.environ.setdefault(key, value)
        logging.getLogger("alembic").setLevel(logging.WARNING)
        from mlflow import MlflowClient

        logging.getLogger("mlflow").setLevel(logging.WARNING)
        return MlflowClient(self.uri)

    @cached_property
    def experiment_id(self) -> str:
        """The experiment's number in this store."""
        experiment = self.client.get_experiment_by_name(EXPERIMENT)
        if experiment is None:
            raise TrackingError(f"tracking.uri: no experiment {EXPERIMENT!r} at {self.shown}")
        return str(experiment.experiment_id)

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Keep other processes out: several that migrate one fresh database at once all fail."""
        if self.file is not None:
            with FileLock(f"{self.file}.lock"):
                yield
        elif self.uri.startswith("postgresql"):
            from sqlalchemy import create_engine, text

            engine = create_engine(self.uri)
            try:
                with engine.connect() as connection:  # the lock is the connection's, and ends with it
                    connection.execute(text(f"SELECT pg_advisory_lock({_LOCK})"))
                    yield
            finally:
                engine.dispose()
        else:  # a server has one of its own
            yield

    def _artifacts(self) -> str | None:
        """Return where artifacts go: beside a local database, else wherever the server puts them."""
        if self.uri.startswith(("http:", "https:")):
            return None
        folder = self.file.parent if self.file is not None else Path("outputs").absolute()
        return (folder / "artifacts").as_uri()

    @contextmanager
    def _reporting(self, what: str) -> Iterator[None]:
        """Turn whatever MLflow, SQLAlchemy or the system raise into one error of ours."""
        try:
            yield
        except TrackingError:
            raise
        except Exception as problem:
            raise TrackingError(
                f"tracking.uri: expected an MLflow store that can be written; {self.shown} {what}: "
                f"{_reason(problem)}"
            ) from problem


@cache
def _store_at(uri: str, absolute: str) -> Store:
    return Store(uri)


def open_store(uri: str) -> Store:
    """Return the store at an address, the same object for all who ask in this process; nothing is touched yet."""
    return _store_at(uri, Store(uri).uri)


def _reason(problem: Exception) -> str:
    return next(iter(str(problem).strip().splitlines()), type(problem).__name__)


def _may_pass(problem: Exception) -> bool:
    """Tell whether a failure is of the kind that ends by itself: no connection, a locked database, a restart."""
    from mlflow.exceptions import MlflowException
    from requests.exceptions import RequestException
    from sqlalchemy.exc import InterfaceError, OperationalError

    if isinstance(problem, MlflowException):
        passing = ("TEMPORARILY_UNAVAILABLE", "INTERNAL_ERROR", "REQUEST_LIMIT_EXCEEDED", "BAD_REQUEST")
        return problem.error_code in passing
    return isinstance(
        problem, RequestException | OperationalError | InterfaceError | ConnectionError | TimeoutError
    )


def _check_writable(file: Path) -> None:
    """Take SQLite's lock for writing; MLflow would try again for minutes where that fails."""
    if file.exists() and not os.access(file, os.W_OK):
        raise PermissionError(f"{file} is read-only")
    with closing(sqlite3.connect(file, timeout=10.0, isolation_level=None)) as database:
        database.execute("BEGIN IMMEDIATE")
        database.execute("ROLLBACK")
