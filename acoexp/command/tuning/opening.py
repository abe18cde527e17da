"""Optuna's own things made from ours: what chooses, what is chosen from, and the database of a study."""

from __future__ import annotations

import time
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from acoexp.command.tuning.space import Choice, Numbers
from acoexp.errors import SettingsError
from acoexp.parameters import values_of
from acoexp.tracking.mlflow.store import Store

if TYPE_CHECKING:
    from optuna.distributions import BaseDistribution
    from optuna.samplers import BaseSampler
    from optuna.storages import RDBStorage

_BUSY = 60.0
"""Seconds for which an SQLite database may be locked by other processes with the same study."""
_ATTEMPTS = 5
"""How often a fresh database is opened: of several processes that make its tables at once, all but one fail."""


@contextmanager
def quiet() -> Iterator[None]:
    """Let Optuna say nothing but what it raises; what it warns of has been checked, or is its own business."""
    import optuna

    optuna.logging.set_verbosity(optuna.logging.ERROR)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield


def distribution(values: Numbers | Choice) -> BaseDistribution:
    """Return values as Optuna knows them."""
    from optuna.distributions import CategoricalDistribution, FloatDistribution, IntDistribution

    if isinstance(values, Choice):
        return CategoricalDistribution(values.ends)
    if values.whole:
        return IntDistribution(int(values.low), int(values.high), log=values.log, step=int(values.step or 1))
    return FloatDistribution(values.low, values.high, log=values.log, step=values.step)


def sampler_of(name: str, keys: Any, trials_before: int) -> BaseSampler:
    """Return what chooses.

    Args:
        name: Its name; of ``grid`` any will do, as a study is told what to take.
        keys: Its keys.
        trials_before: How many trials the study has: with the same seed another command draws other numbers.
    """
    from optuna import samplers

    kinds = {"cmaes": samplers.CmaEsSampler, "nsgaii": samplers.NSGAIISampler, "tpe": samplers.TPESampler}
    given = {key: value for key, value in values_of(keys).items() if value is not None}
    if "seed" in given:
        given["seed"] += trials_before
    if name == "cmaes":
        given["warn_independent_sampling"] = False
    made: BaseSampler = kinds.get(name, samplers.RandomSampler)(**given)
    return made


def storage_at(store: Store) -> RDBStorage:
    """Return the database of studies at an address; its tables are made if they are not there.

    Raises:
        SettingsError: if it is a database of something else.
        Exception: whatever Optuna and SQLAlchemy raise where it cannot be reached or written.
    """
    from optuna.storages import RDBStorage

    if store.folder is not None:
        store.folder.mkdir(parents=True, exist_ok=True)
    options = {} if store.file is None else {"connect_args": {"timeout": _BUSY}}
    _check_own(store, options)
    for attempt in range(_ATTEMPTS):
        try:
            return RDBStorage(store.uri, engine_kwargs=options)
        except Exception as problem:
            if attempt == _ATTEMPTS - 1 or not _is_being_made(problem):
                raise
            time.sleep(0.2 * (attempt + 1))
    raise AssertionError


def _check_own(store: Store, options: dict[str, Any]) -> None:
    """Refuse a database that another program has laid out, as MLflow its store: neither could upgrade it then."""
    from sqlalchemy import create_engine, inspect

    engine = create_engine(store.uri, **options)
    try:
        tables = inspect(engine).get_table_names()
    finally:
        engine.dispose()
    if "alembic_version" in tables and "studies" not in tables:
        raise SettingsError(
            f"hydra.sweeper.storage: expected a database of its own; got {store.shown}, which is another program's"
        )


def _is_being_made(problem: Exception) -> bool:
    """Tell whether another process makes the tables at this moment."""
    from sqlalchemy.exc import IntegrityError, OperationalError, ProgrammingError

    said = str(problem)
    return isinstance(problem, IntegrityError | OperationalError | ProgrammingError) and any(
        word in said for word in ("already exists", "UNIQUE", "unique", "locked")
    )
