"""The folder of the kernel cache: this user's alone, or none, and then with a line that says why."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from acoexp.kernels.cache_folder import cache_root, is_ours, usable_folder

pytestmark = pytest.mark.skipif(not hasattr(os, "getuid"), reason="owners of POSIX")


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of an empty cache, for this process."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return cache_root()


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
