"""An MLflow store at an address: made ready once, then asked again and again while it is away.

mlflow takes over a second to import, so it is imported when the store is touched and not before.
"""

from __future__ import annotations

import logging
import os
import re
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, cached_property
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar
from urllib.parse import unquote

from filelock import FileLock

from acoexp.errors import StoreGoneError, TrackingError
from acoexp.tracking.mlflow.database import address_of
from acoexp.tracking.mlflow.failures import lasts, may_pass, reason_of
from acoexp.tracking.mlflow.making import check_is_file, check_openable, check_writable, make_whole
from acoexp.tracking.mlflow.masking import masked
from acoexp.tracking.mlflow.moving import ARTIFACTS, bring_artifacts_along

if TYPE_CHECKING:
    from mlflow import MlflowClient
    from mlflow.entities import Run

log = logging.getLogger(__name__)

EXPERIMENT = "acoexp"
"""Name of the experiment where none is chosen."""
PATIENCE = 90.0
"""Seconds for which a store may be away before a trial is given up."""

_SQLITE = re.compile(r"(sqlite(?:\+\w+)?:///)([^?]*)(.*)", re.DOTALL)
_LOCK_PATIENCE = 600.0
"""Seconds for which a fresh store may be made by another process, and looked at by others after it, one by one."""

_PAGE = 1000
_MLFLOW_SETTINGS = {
    "MLFLOW_ENABLE_ARTIFACTS_PROGRESS_BAR": "false",
    "MLFLOW_SUPPRESS_PRINTING_URL_TO_STDOUT": "true",  # two lines for each trial, with the password of the address
    "MLFLOW_HTTP_REQUEST_MAX_RETRIES": "2",  # how long to wait for a server that is away is our decision
}
_QUIET = {"alembic": logging.WARNING, "mlflow": logging.WARNING, "mlflow.store.db.utils": logging.CRITICAL}
"""Loggers, each with the level from which on it is heard: the last prints tracebacks of what it raises as well."""
_LOCK = 0x61636F657870  # "acoexp"
_T = TypeVar("_T")


class Store:
    """An MLflow store.

    Attributes:
        uri: Its address.
        experiment: Name of the experiment in it that runs are in.
        file: Its database file, if it is one of SQLite's.
        folder: Where that lies.
        shown: The address as it may be shown, without a password.
    """

    def __init__(self, uri: str, experiment: str = EXPERIMENT) -> None:
        self.experiment = experiment
        sqlite = _SQLITE.fullmatch(uri)
        self.file = None if sqlite is None else Path(unquote(sqlite[2])).absolute()
        self._scheme, self._query = ("", "") if sqlite is None else (sqlite[1], sqlite[3])
        self.uri = uri if self.file is None else f"{address_of(self.file, self._scheme)}{self._query}"
        self.folder = None if self.file is None else self.file.parent
        self.shown = masked(uri, uri)
        self._is_gone = False  # patience ran out once: nobody waits for it again

    def check(self) -> None:
        """Look whether a local database can be written, or made in its folder; MLflow is not imported for that.

        Raises:
            TrackingError: if it cannot.
        """
        with self._reporting("cannot be opened"):
            if self.file is not None:
                self.file.parent.mkdir(parents=True, exist_ok=True)
                check_is_file(self.file)
                if self.file.exists():
                    check_writable(self.file)

    def prepare(self) -> None:
        """Create the store and the experiment if they are not there; find the artifacts of one that was moved.

        Raises:
            TrackingError: if the store cannot be reached or written.
        """
        self._is_gone = False
        self.__dict__.pop("experiment_id", None)  # the store that was there before may have been another
        with self._reporting("cannot be opened"):
            if self.file is not None:
                self.file.parent.mkdir(parents=True, exist_ok=True)
                import_module("mlflow.store.tracking.sqlalchemy_store")  # seconds that nobody else need wait for
            with self._alone():
                if self.file is not None:
                    make_whole(self.file, self._make)
                    check_writable(self.file)
                self._prepare_experiment(self.client)
                if self.file is not None:
                    bring_artifacts_along(self.file, self.experiment)

    def check_there(self) -> None:
        """Look once for the experiment, without waiting for a store that is away.

        Raises:
            TrackingError: if the store cannot be reached, or has no such experiment.
        """
        with self._reporting("cannot be opened"):
            _ = self.experiment_id

    def with_retries(self, action: Callable[[], _T], what: str) -> _T:
        """Do something with the store, again and again while it is away.

        Args:
            action: What to do; it may be done more than once.
            what: What is said of the store if it fails, such as ``does not take a trial``.

        Raises:
            TrackingError: if it fails for good.
            StoreGoneError: if the store stays away, or takes nothing any more.
        """
        began, pause, warned = time.monotonic(), 0.1, False
        with self._reporting(what):
            while True:
                try:
                    return action()
                except Exception as problem:
                    self._give_up_or_wait(problem, what, time.monotonic() - began + pause)
                if not warned:
                    warned = True
                    log.warning("%s %s; trying again for %.0f s", self.shown, what, PATIENCE)
                time.sleep(pause)
                pause = min(2.0 * pause, 5.0)

    def _give_up_or_wait(self, problem: Exception, what: str, waited: float) -> None:
        """Raise what is to be told, unless the problem may pass and there is patience left."""
        if may_pass(problem) and not self._is_gone:
            if waited <= PATIENCE:
                return
            what = f"{what} for {PATIENCE:.0f} s"
        elif not lasts(problem):
            raise problem
        self._is_gone = True
        raise StoreGoneError(f"tracking.uri: {self.shown} {what}: {reason_of(problem, self.uri)}") from problem

    def search(self, condition: str, at_most: int | None = None) -> list[Run]:
        """Return the runs of the experiment that meet a condition in MLflow's language, the oldest first.

        Args:
            condition: The condition; empty for all runs.
            at_most: How many are of use: where there are more, only some are returned, but more than these.
        """
        runs: list[Run] = []
        whole = " AND ".join(
            filter(None, ["attributes.start_time >= 0", condition])
        )  # MLflow fails at one without
        size = _PAGE if at_most is None else min(_PAGE, at_most + 1)
        token = None
        while at_most is None or len(runs) <= at_most:
            page = self.client.search_runs(
                [self.experiment_id], whole, 1, size, ["attributes.start_time ASC"], token
            )
            runs.extend(page)
            token = page.token
            if not token:
                break
        return runs

    @cached_property
    def client(self) -> MlflowClient:
        """MLflow's client for this store.

        Raises:
            TrackingError: if its file is none that this MLflow can open.
        """
        if self.file is not None:
            check_openable(self.file)
        return _client_for(self.uri)

    @cached_property
    def experiment_id(self) -> str:
        """The experiment's number in this store."""
        experiment = self.client.get_experiment_by_name(self.experiment)
        if experiment is None:
            raise TrackingError(f"tracking.uri: no experiment {self.experiment!r} at {self.shown}")
        return str(experiment.experiment_id)

    def _make(self, draft: Path) -> None:
        """Make this store in another file."""
        self._prepare_experiment(_client_for(f"{address_of(draft, self._scheme)}{self._query}"))

    def _prepare_experiment(self, client: MlflowClient) -> None:
        experiment = client.get_experiment_by_name(self.experiment)
        if experiment is None:
            client.create_experiment(self.experiment, self._artifacts())
        elif experiment.lifecycle_stage != "active":
            client.restore_experiment(experiment.experiment_id)

    @contextmanager
    def _alone(self) -> Iterator[None]:
        """Keep other processes out: several that migrate one fresh database at once all fail."""
        if self.file is not None:
            with FileLock(f"{self.file}.lock", timeout=_LOCK_PATIENCE):
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
        return (folder / ARTIFACTS).as_uri()

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
                f"{reason_of(problem, self.uri)}"
            ) from problem


@cache
def _store_at(uri: str, absolute: str, experiment: str) -> Store:
    return Store(uri, experiment)


def open_store(uri: str, experiment: str = EXPERIMENT) -> Store:
    """Return the store at an address, the same object for all who ask in this process; nothing is touched yet."""
    return _store_at(uri, Store(uri).uri, experiment)


def _client_for(uri: str) -> MlflowClient:
    """Return MLflow's client for an address; MLflow says nothing but what is raised.

    SQLite's driver is named, as MLflow would else make a folder of the name that is encoded in the address.
    """
    for key, value in _MLFLOW_SETTINGS.items():
        os.environ.setdefault(key, value)
    from mlflow import MlflowClient

    for name, level in _QUIET.items():  # after the import, which sets them
        logging.getLogger(name).setLevel(level)
    return MlflowClient(re.sub("^sqlite:", "sqlite+pysqlite:", uri))
