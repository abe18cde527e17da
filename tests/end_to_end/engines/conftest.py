"""One server of each kind for all tests of engines; tests whose server or extra is not installed are skipped."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack
from typing import TypeVar

import pytest
import servers

T = TypeVar("T")


@pytest.fixture(scope="session")
def slurm() -> Iterator[dict[str, str]]:
    """The environment in which a real Slurm cluster is at hand."""
    pytest.importorskip("hydra_plugins.hydra_submitit_launcher")
    yield from _up(servers.slurm)


@pytest.fixture(scope="session")
def ray() -> Iterator[dict[str, str]]:
    """The environment in which a real Ray cluster is at hand."""
    pytest.importorskip("hydra_plugins.hydra_ray_launcher")
    yield from _up(servers.ray)


@pytest.fixture(scope="session")
def joblib() -> dict[str, str]:
    """The environment for joblib, which needs none."""
    pytest.importorskip("hydra_plugins.hydra_joblib_launcher")
    return {}


@pytest.fixture(scope="session")
def fresh_database() -> Iterator[Callable[[str], str]]:
    """What makes a database in a real PostgreSQL and returns its address."""
    pytest.importorskip("psycopg")
    yield from _up(servers.postgresql)


def _up(server: Callable[[], AbstractContextManager[T]]) -> Iterator[T]:
    with ExitStack() as stack:
        try:
            started = stack.enter_context(server())
        except servers.NoServerError as problem:
            pytest.skip(str(problem))
        yield started
