"""Packages that are installed for the length of a test: as entry points alone, or as files."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import metadata
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any

import pytest
from running import install as install_files

from acoexp.registry import entries, folders, parts


def forget() -> None:
    """Forget what is known of the packages that are installed."""
    for known in (
        entries.entries, entries._claims, parts._check_unambiguous, parts._load, folders.plugin_conf_dirs
    ):  # fmt: skip
        known.cache_clear()


@pytest.fixture
def install(monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., None]]:
    """Return a function that adds diffusions, each as name=value, to the packages that are installed."""

    def pretend(*added: tuple[str, str]) -> None:
        installed = metadata.entry_points
        new = [EntryPoint(name, value, "acoexp.diffusion") for name, value in added]

        def entry_points(group: str) -> list[EntryPoint]:
            return [*installed(group=group), *(entry for entry in new if entry.group == group)]

        monkeypatch.setattr("acoexp.registry.entries.entry_points", entry_points)
        forget()

    yield pretend
    monkeypatch.undo()
    forget()


@pytest.fixture
def install_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[..., None]]:
    """Return a function that installs a package of version 1.0: its name, its entry points, its files."""

    def put(name: str, entries: str, files: dict[str, Any]) -> None:
        install_files(tmp_path, name, entries, files)
        monkeypatch.syspath_prepend(tmp_path)
        forget()

    yield put
    monkeypatch.undo()
    forget()
