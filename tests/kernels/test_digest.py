"""Digests of code: another whenever what is compiled may be another, none where nobody can know."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType

import numba
import pytest

from acoexp.colony.compiled import compiled
from acoexp.kernels.digest import digest_of, digest_of_sources
from acoexp.strategies.diffusion.none import stay


def test_numbas_own_settings_are_part_of_the_digest(monkeypatch: pytest.MonkeyPatch) -> None:
    before = digest_of((stay,))
    monkeypatch.setenv("NUMBA_OPT", "2")
    assert digest_of((stay,)) != before


def test_how_many_threads_numba_has_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    before = digest_of((stay,))
    monkeypatch.setenv("NUMBA_NUM_THREADS", "1")
    assert digest_of((stay,)) == before


def test_a_kernel_made_inside_a_function_has_no_digest() -> None:
    @compiled
    def inner(number: float) -> float:
        return number

    assert digest_of((stay, inner)) is None


def test_every_source_file_of_a_package_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = ModuleType("windy")
    package.__path__ = [str(tmp_path)]
    monkeypatch.setitem(sys.modules, "windy", package)
    digests = set()
    for name in ("a.py", "deep/b.py"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("x = 1")
        digest_of_sources.cache_clear()
        digests.add(digest_of_sources("windy"))
    assert len(digests) == 2


def test_a_package_that_is_not_imported_has_no_digest() -> None:
    assert digest_of_sources("nowhere_to_be_found") is None


def test_the_version_of_numba_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    before = digest_of((stay,))
    monkeypatch.setattr(numba, "__version__", "0.0")
    assert digest_of((stay,)) != before
