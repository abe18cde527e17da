"""The kernel cache: compiled once for all processes, and never run after an edit.

Tried out on a loop that compiles in an instant; real ones, and several processes, are in
tests/end_to_end/test_kernel_cache.py.
"""

from __future__ import annotations

import logging
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import pytest

from acoexp.colony.compiled import compiled
from acoexp.kernels.cache import compile_once
from acoexp.kernels.cache_folder import cache_root
from acoexp.strategies.diffusion.none import stay

pytestmark = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")

DAY = 24 * 3600.0


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of an empty cache, for this process."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert tmp_path in cache_root().parents
    return cache_root()


def new_loop() -> Any:
    """Return what nobody has compiled yet."""

    @compiled
    def loop(number: float) -> float:
        return number + 1.0

    return loop


def loaded(loop: Any) -> bool:
    """Compile a loop, or load it; tell which."""
    compile_once(loop, (stay, None), (2.0,))
    assert loop(2.0) == 3.0
    return bool(sum(loop.stats.cache_hits.values()))


def kept_files(root: Path) -> list[Path]:
    return [file for file in root.rglob("*") if file.is_file() and file.name != "lock"]


def test_what_was_compiled_is_loaded_after_that(root: Path, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO)
    assert not loaded(new_loop())
    assert len(caplog.messages) == len(kept_files(root)) == 1
    assert loaded(new_loop())
    assert len(caplog.messages) == 1


@pytest.mark.parametrize(
    "harm", [lambda kept: b"", lambda kept: kept[:-100], lambda kept: kept[:-1] + bytes([kept[-1] ^ 1])]
)
def test_a_damaged_file_is_made_anew(
    root: Path, harm: Callable[[bytes], bytes], caplog: pytest.LogCaptureFixture
) -> None:
    loaded(new_loop())
    (file,) = kept_files(root)
    file.write_bytes(harm(file.read_bytes()))
    assert not loaded(new_loop())
    assert "damaged" in caplog.text
    assert loaded(new_loop())


def test_where_no_folder_can_be_made_each_process_compiles_for_itself(
    root: Path, caplog: pytest.LogCaptureFixture
) -> None:
    root.parent.write_text("a file where the folder should be")
    assert not loaded(new_loop())
    assert "cannot be used" in caplog.text
    assert not loaded(new_loop())


def test_where_a_file_cannot_be_written_the_compiled_code_still_runs(
    root: Path, caplog: pytest.LogCaptureFixture
) -> None:
    loaded(new_loop())
    (file,) = kept_files(root)
    file.unlink()
    file.mkdir()
    assert not loaded(new_loop())
    assert "cannot be written" in caplog.text
    assert kept_files(root) == []


def test_each_signature_has_a_file_of_its_own(root: Path) -> None:
    for number in (1.0, 1):
        for _ in range(2):
            compile_once(new_loop(), (), (number,))
    assert len(kept_files(root)) == 2


def test_what_nobody_asked_for_in_sixty_days_is_removed(root: Path) -> None:
    for name, age in (("old", 61 * DAY), ("recent", 59 * DAY)):
        (root / name).mkdir(parents=True)
        (root / name / "lock").touch()
        os.utime(root / name, (time.time() - age,) * 2)
    loaded(new_loop())
    assert not (root / "old").exists()
    assert (root / "recent").exists()


def test_what_is_asked_for_stays(root: Path) -> None:
    loaded(new_loop())
    (folder,) = root.iterdir()
    os.utime(folder, (time.time() - 61 * DAY,) * 2)
    assert loaded(new_loop())
    assert time.time() - folder.stat().st_mtime < DAY
