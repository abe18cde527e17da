"""The kernel cache: compiled once for all processes, and never run after an edit.

Tried out on a loop that compiles in an instant; real ones, and several processes, are in
tests/end_to_end/test_kernel_cache.py.
"""

from __future__ import annotations

import logging
import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import pytest

from acoexp.colony.compiled import compiled
from acoexp.kernels.cache import cache_root, compile_once, is_ours, usable_folder
from acoexp.kernels.digest import digest_of
from acoexp.strategies.diffusion.none import stay

pytestmark = [
    pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled"),
    pytest.mark.skipif(not hasattr(os, "getuid"), reason="owners of POSIX"),
]

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
    compile_once(loop, digest_of((stay, None)), (2.0,))
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


LOADING = """
import sys
from acoexp.colony.compiled import compiled_for_python
from acoexp.kernels.cache import compile_once

@compiled_for_python
def loop(number):
    return number + 1.0

@compiled_for_python
def other(number):
    return number * 3.0

compile_once(loop, "digest", (2.0,))
print(loop(2.0), "numba.np.arraymath" in sys.modules, other(2.0))
"""


def test_to_load_nothing_is_read_that_numba_compiles_by_and_more_can_be_compiled_then(root: Path) -> None:
    said = [
        subprocess.run([sys.executable, "-c", LOADING], check=True, capture_output=True, text=True).stdout
        for _ in range(2)
    ]
    assert said == ["3.0 True 6.0\n", "3.0 False 6.0\n"]


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
            compile_once(new_loop(), digest_of(()), (number,))
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


# --- its folder


def test_it_is_made_for_this_user_alone(root: Path) -> None:
    folder = usable_folder("abc")
    assert folder == root / "abc"
    assert folder.stat().st_mode & 0o077 == 0


@pytest.mark.parametrize("mode", [0o777, 0o770, 0o702])
@pytest.mark.parametrize("where", ["acoexp", "acoexp/kernels", "acoexp/kernels/abc"])
def test_one_that_others_can_write_to_is_not_used(
    where: str, mode: int, root: Path, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    usable_folder("abc")
    (tmp_path / where).chmod(mode)
    assert usable_folder("abc") is None
    assert "can be written by another user" in caplog.text


def test_one_that_lies_in_what_others_can_exchange_is_not_used(root: Path, tmp_path: Path) -> None:
    tmp_path.chmod(0o777)
    assert usable_folder("abc") is None
    tmp_path.chmod(0o1777)
    assert usable_folder("abc") is not None


@pytest.mark.skipif(os.getuid() != 0, reason="only root gives files away")
def test_one_of_another_user_is_not_used(root: Path) -> None:
    folder = usable_folder("abc")
    assert folder is not None
    os.chown(folder, 12345, 12345)
    assert usable_folder("abc") is None


@pytest.mark.skipif(os.getuid() != 0, reason="only root gives files away")
def test_a_file_of_another_user_is_not_ours(tmp_path: Path) -> None:
    file = tmp_path / "kernel"
    file.touch(mode=0o600)
    assert is_ours(file)
    os.chown(file, 12345, 12345)
    assert not is_ours(file)


def test_a_user_without_a_home_has_none(monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture) -> None:
    def no_home(_: str) -> str:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr("platformdirs.user_cache_dir", no_home)
    assert usable_folder("abc") is None
    assert "every process compiles for itself: Could not determine home" in caplog.text


def test_a_lock_that_cannot_be_written_leaves_none(root: Path) -> None:
    folder = usable_folder("abc")
    assert folder is not None
    (folder / "lock").unlink()
    (folder / "lock").mkdir()
    assert usable_folder("abc") is None
