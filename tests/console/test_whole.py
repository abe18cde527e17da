"""Files and folders are written whole or not at all: an error leaves what was there, and no draft behind."""

from __future__ import annotations

from pathlib import Path

import pytest
from running import listing

from acoexp.console.whole import whole_file, whole_folder, write_whole


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


def test_a_folder_that_cannot_take_its_place_leaves_the_old_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with whole_folder(tmp_path / "mine") as draft:
        (draft / "page").write_text("old", encoding="utf-8")

    def replace(self: Path, target: Path) -> Path:
        if self.name.endswith("-draft"):
            raise OSError("disk full")
        return self.rename(target)

    monkeypatch.setattr(Path, "replace", replace)
    with pytest.raises(OSError, match="disk full"), whole_folder(tmp_path / "mine") as draft:
        (draft / "page").write_text("new", encoding="utf-8")
    assert (tmp_path / "mine" / "page").read_text("utf-8") == "old"
    assert listing(tmp_path) == {"mine", "mine/page"}


def test_a_draft_that_a_killed_process_left_is_written_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("os.getpid", lambda: 7)  # as a process that had this number was killed
    (tmp_path / ".mine-7-draft").mkdir()
    (tmp_path / ".mine-7-draft" / "left").touch()
    with whole_folder(tmp_path / "mine") as draft:
        (draft / "page").touch()
    assert listing(tmp_path) == {"mine", "mine/page"}
