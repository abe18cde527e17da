"""Two folders swap their names, or nothing is done."""

from __future__ import annotations

import errno
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
from running import listing

from acoexp.console.exchange import exchange


@pytest.fixture
def folders(tmp_path: Path) -> tuple[Path, Path]:
    """Return two folders with a file each."""
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        (tmp_path / name / name).touch()
    return tmp_path / "one", tmp_path / "other"


@pytest.mark.skipif(sys.platform != "linux", reason="others cannot")
def test_they_swap_their_names(folders: tuple[Path, Path], tmp_path: Path) -> None:
    assert exchange(*folders)
    assert listing(tmp_path) == {"one", "one/other", "other", "other/one"}


@pytest.mark.skipif(sys.platform != "linux", reason="others cannot")
def test_one_that_is_not_there_is_an_error(folders: tuple[Path, Path], tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        exchange(folders[0], tmp_path / "nowhere")
    assert listing(tmp_path) == {"one", "one/one", "other", "other/other"}


@pytest.mark.parametrize("problem", [errno.ENOSYS, errno.EINVAL])
def test_a_disk_that_cannot_says_so(
    problem: int, folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ctypes.CDLL", lambda *_, **__: SimpleNamespace(renameat2=lambda *_: -1))
    monkeypatch.setattr("ctypes.get_errno", lambda: problem)
    assert not exchange(*folders)


def test_a_system_that_has_no_such_function_cannot(
    folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("ctypes.CDLL", lambda *_, **__: SimpleNamespace())
    assert not exchange(*folders)
