"""Files and folders are written whole or not at all: an error leaves what was there, and no draft behind."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager
from errno import ENOSPC
from pathlib import Path

import pytest
from running import listing

from acoexp.console.whole import whole_file, whole_folder, write_whole

Whole = Callable[[Path], AbstractContextManager[Path]]


def test_a_file_takes_the_place_of_the_one_that_was_there(tmp_path: Path) -> None:
    file = tmp_path / "record"
    for content in ("first", "ä second", b"\xff third"):
        write_whole(file, content)
        assert file.read_bytes() == (content if isinstance(content, bytes) else content.encode())
    assert listing(tmp_path) == {"record"}


@pytest.mark.parametrize("problem", [OSError, KeyboardInterrupt])
def test_an_error_while_a_file_is_written_leaves_the_old_one(problem: type[BaseException], tmp_path: Path) -> None:
    file = tmp_path / "record"
    write_whole(file, "old")
    with pytest.raises(problem), whole_file(file) as draft:  # noqa: PT012
        draft.write_text("half of the n", encoding="utf-8")
        assert file.read_text("utf-8") == "old"
        raise problem
    assert file.read_text("utf-8") == "old"
    assert listing(tmp_path) == {"record"}


@pytest.mark.parametrize("whole", [whole_file, whole_folder])
def test_a_disk_that_is_full_is_told_with_what_was_to_be_written(whole: Whole, tmp_path: Path) -> None:
    with pytest.raises(OSError, match="No space") as caught, whole(tmp_path / "record"):
        raise OSError(ENOSPC, "No space left on device")
    assert caught.value.filename == str(tmp_path / "record")


def test_an_error_while_the_first_file_is_written_leaves_none(tmp_path: Path) -> None:
    with pytest.raises(OSError, match="disk full"), whole_file(tmp_path / "record") as draft:  # noqa: PT012
        draft.touch()
        raise OSError("disk full")
    assert listing(tmp_path) == set()


def test_a_folder_takes_the_place_of_the_one_that_was_there_with_all_that_was_in_it(tmp_path: Path) -> None:
    for name in ("first", "second"):
        with whole_folder(tmp_path / "all" / "reports" / "mine") as draft:
            (draft / name).touch()
    assert listing(tmp_path / "all" / "reports") == {"mine", "mine/second"}


@pytest.mark.parametrize("problem", [OSError, KeyboardInterrupt])
def test_an_error_while_a_folder_is_written_leaves_the_old_one(
    problem: type[BaseException], tmp_path: Path
) -> None:
    with whole_folder(tmp_path / "mine") as draft:
        (draft / "page").write_text("old", encoding="utf-8")
    with pytest.raises(problem), whole_folder(tmp_path / "mine") as draft:  # noqa: PT012
        (draft / "page").write_text("new", encoding="utf-8")
        raise problem
    assert (tmp_path / "mine" / "page").read_text("utf-8") == "old"
    assert listing(tmp_path) == {"mine", "mine/page"}


@pytest.fixture(params=["at once", "one after the other"])
def swapped(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    """Let folders swap their names as Linux can, and as others have to."""
    if request.param != "at once":
        monkeypatch.setattr("acoexp.console.whole.exchange", lambda one, other: False)
    return str(request.param)


def written(folder: Path, page: str, keep: Path | None = None) -> None:
    """Write a folder with a page."""
    with whole_folder(folder, keep) as draft:
        (draft / "page").write_text(page, encoding="utf-8")


def test_what_was_there_may_be_kept(swapped: str, tmp_path: Path) -> None:
    written(tmp_path / "mine", "old", tmp_path / "not needed")
    written(tmp_path / "mine", "new", tmp_path / "kept")
    assert listing(tmp_path) == {"mine", "mine/page", "kept", "kept/page"}
    assert [(tmp_path / name / "page").read_text("utf-8") for name in ("mine", "kept")] == ["new", "old"]


@pytest.mark.parametrize("keep", [None, "kept"])
def test_a_folder_that_cannot_take_its_place_leaves_the_old_one(
    swapped: str, keep: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    written(tmp_path / "mine", "old")

    def fail(one: Path, other: Path) -> Path:
        if "draft" in one.name or one.name == "kept":
            raise OSError("disk full")
        return one.rename(other)

    if swapped == "at once":
        monkeypatch.setattr("acoexp.console.whole.exchange", fail)
    else:
        monkeypatch.setattr(Path, "replace", fail)
    with pytest.raises(OSError, match="disk full"):
        written(tmp_path / "mine", "new", None if keep is None else tmp_path / keep)
    assert (tmp_path / "mine" / "page").read_text("utf-8") == "old"
    assert listing(tmp_path) == {"mine", "mine/page"}


@pytest.mark.skipif(sys.platform != "linux", reason="others cannot swap names at once")
def test_at_no_moment_there_is_none(tmp_path: Path) -> None:
    """Another process looks all the time."""
    written(tmp_path / "mine", "0")
    looks = "import os, sys\nwhile os.path.exists('mine/page'): os.path.exists('end') and sys.exit(7)"
    with subprocess.Popen([sys.executable, "-c", looks], cwd=tmp_path) as looking:
        for number in range(300):
            written(tmp_path / "mine", str(number))
        (tmp_path / "end").touch()
    assert looking.returncode == 7


def test_a_link_is_replaced_and_what_it_leads_to_stays(swapped: str, tmp_path: Path) -> None:
    written(tmp_path / "elsewhere", "theirs")
    (tmp_path / "mine").symlink_to("elsewhere")
    written(tmp_path / "mine", "new")
    assert listing(tmp_path) == {"elsewhere", "elsewhere/page", "mine", "mine/page"}


GONE, LIVING = 4_000_000, os.getppid()
"""Numbers of processes: the first is higher than Linux gives any."""


@pytest.mark.parametrize("host", ["", f"{socket.gethostname()}-"])
def test_what_a_killed_process_left_is_removed_when_the_same_is_written_again(host: str, tmp_path: Path) -> None:
    for number in (GONE, os.getpid(), LIVING):
        written(tmp_path / f".mine-{host}{number}-draft", "half")
        written(tmp_path / f".mine-{host}{number}-old", "old")
    written(tmp_path / ".yours-1-draft", "of another name")
    written(tmp_path / ".mine-another_machine-4000000-draft", "of another machine")
    written(tmp_path / "mine", "new")
    assert {path.name for path in tmp_path.iterdir()} == {
        "mine", f".mine-{host}{LIVING}-draft", f".mine-{host}{LIVING}-old", ".yours-1-draft",
        ".mine-another_machine-4000000-draft",
    }  # fmt: skip


def test_what_a_process_had_set_aside_when_it_was_killed_is_brought_back(tmp_path: Path) -> None:
    written(tmp_path / f".mine-{GONE}-old", "old")
    with pytest.raises(OSError, match="disk full"), whole_folder(tmp_path / "mine"):
        raise OSError("disk full")
    assert (tmp_path / "mine" / "page").read_text("utf-8") == "old"
    assert listing(tmp_path) == {"mine", "mine/page"}


def test_a_process_that_has_ended_and_is_still_listed_is_gone(tmp_path: Path) -> None:
    with subprocess.Popen([sys.executable, "-c", ""]) as ended:
        os.waitid(os.P_PID, ended.pid, os.WEXITED | os.WNOWAIT)
        written(tmp_path / f".mine-{ended.pid}-draft", "half")
        written(tmp_path / "mine", "new")
    assert listing(tmp_path) == {"mine", "mine/page"}


def test_the_draft_of_a_file_that_a_killed_process_left_is_removed_too(tmp_path: Path) -> None:
    (tmp_path / f".record-{GONE}-draft").touch()
    write_whole(tmp_path / "record", "new")
    assert listing(tmp_path) == {"record"}
