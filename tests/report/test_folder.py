"""A report's folder: where none may be written is told before anything runs, and nobody's files are a report's."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest
from running import listing

from acoexp import SettingsError
from acoexp.report.folder import MADE_BY, check_folder, is_empty, is_made_by, write_mark

MINE = {"map": "yard"}


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder that the command runs in."""
    (tmp_path / "home").mkdir()
    monkeypatch.chdir(tmp_path / "home")
    return tmp_path / "home"


def report(folder: Path) -> Path:
    """Write a report that is a page."""
    folder.mkdir(parents=True)
    (folder / "page").write_text("page", encoding="utf-8")
    write_mark(folder, MINE)
    return folder


def refused(folder: str | Path, *used: str) -> str:
    """Return why a folder is refused, without the beginning; nothing may have changed."""
    before = listing(Path("..").resolve())
    with pytest.raises(SettingsError) as caught:
        check_folder(Path(folder), [Path(), *map(Path, used)])
    assert listing(Path("..").resolve()) == before
    beginning = "report.folder: expected a new or an empty folder, or one with a report; got "
    assert str(caught.value).startswith(beginning)
    return str(caught.value).removeprefix(beginning)


@pytest.mark.parametrize("folder", ["new", "a/b/c", "../new", "a/../b", "$x [y] {z}=", "ä", "new/"])
def test_a_new_folder_is_welcome_and_not_made_yet(folder: str) -> None:
    check_folder(Path(folder), [Path()])
    assert listing(Path()) == set()


def test_an_empty_one_is_and_one_with_a_report() -> None:
    Path("empty").mkdir()
    report(Path("mine"))
    (Path("mine") / "notes").touch()  # it is kept then, under its date
    for folder in ("empty", "mine"):
        check_folder(Path(folder), [Path()])


@pytest.mark.parametrize("folder", [".", "..", "/", "", "a/..", "../home", "../../.."])
def test_where_the_command_runs_nothing_else_takes_its_place(folder: str) -> None:
    assert refused(folder).endswith(": the command itself runs in it, or writes there")


def test_a_report_that_one_stands_in_is_no_place_for_another(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(report(Path("mine")))
    assert refused(home / "mine").endswith("the command itself runs in it, or writes there")


def test_nor_where_it_writes_other_things() -> None:
    assert refused("outputs", "outputs/reports") == "'outputs': the command itself runs in it, or writes there"
    assert refused("outputs/reports", "outputs/reports").endswith("or writes there")
    check_folder(Path("outputs/reports/mine"), [Path("outputs/reports")])


def test_a_folder_with_other_files_is_left_alone() -> None:
    Path("thesis").mkdir()
    Path("thesis/chapter").touch()
    assert refused("thesis") == "'thesis': other files are in it"
    Path("thesis", MADE_BY).symlink_to("chapter")
    assert refused("thesis") == "'thesis': other files are in it"


def make(kind: str) -> None:
    """Make something that is no folder."""
    makers: dict[str, Callable[[], object]] = {
        "file": lambda: Path("x").touch(),
        "pipe": lambda: os.mkfifo("x"),
        "link": lambda: Path("x").symlink_to("elsewhere"),
        "link to a report": lambda: Path("x").symlink_to(report(Path("mine")).absolute()),
        "link to itself": lambda: Path("x").symlink_to("x"),
    }
    makers[kind]()


@pytest.mark.parametrize(
    ("kind", "why"),
    [
        ("file", "no folder"),
        ("pipe", "no folder"),
        ("link", "a link"),
        ("link to a report", "a link"),
        ("link to itself", "a link"),
    ],
)
def test_what_is_no_folder_is_left_alone(kind: str, why: str) -> None:
    make(kind)
    assert refused("x") == f"'x': {why}"


def test_a_file_on_the_way_is_named(home: Path) -> None:
    Path("file").touch()
    assert refused("file/a/b") == f"'file/a/b': {home / 'file'} is no folder"


def test_devices_and_disks_are_no_folders() -> None:
    assert refused("/dev/null") == "'/dev/null': no folder"
    assert "the top of a disk" in refused("/proc")


@pytest.mark.parametrize("folder", ["a" * 250, "ä" * 120, "a" * 5000, "a\0b"])
def test_names_that_no_file_can_have_are_refused(folder: str) -> None:
    assert len(refused(folder)) < 400


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_where_one_may_not_write_or_read(home: Path) -> None:
    Path("closed").mkdir(mode=0o500)
    assert refused("closed/new") == f"'closed/new': {home / 'closed'} may not be written"
    Path("hidden").mkdir(mode=0o300)
    assert refused("hidden") == "'hidden': Permission denied"


def test_where_one_may_not_write_is_told_before_anything_runs(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda path, mode: False)
    assert refused("a/new") == f"'a/new': {home} may not be written"


def test_what_was_marked_is_made_by_what_the_mark_says() -> None:
    mine = report(Path("mine"))
    assert is_made_by(mine, MINE)
    assert not is_made_by(mine, {"map": "garden"})
    (mine / "page").unlink()
    assert is_made_by(mine, MINE)


def test_what_a_person_did_is_seen_in_folders_too() -> None:
    changes: list[Callable[[Path], object]] = [
        lambda mine: (mine / "page").write_text("mine", encoding="utf-8"),
        lambda mine: (mine / "notes").touch(),
        lambda mine: (mine / "a").symlink_to("/"),
        lambda mine: os.mkfifo(mine / "pipe"),
        lambda mine: ((mine / "a").mkdir(), (mine / "a" / "notes").touch()),
        lambda mine: ((mine / "page").unlink(), (mine / "page").symlink_to("/etc/passwd")),
    ]
    for number, change in enumerate(changes):
        mine = report(Path(f"mine{number}"))
        change(mine)
        assert not is_made_by(mine, MINE), number


@pytest.mark.parametrize(
    "mark", ["", "[", "1", "[" * 100_000, '{"made by": {}}', '{"made by": {"map": "yard"}, "files": 3}', "\udcff"]
)
def test_a_mark_that_is_none_marks_nothing(mark: str) -> None:
    mine = report(Path("mine"))
    (mine / MADE_BY).write_bytes(mark.encode("utf-8", "surrogateescape"))
    assert not is_made_by(mine, MINE)


def test_a_pipe_for_a_mark_is_not_waited_for() -> None:
    Path("mine").mkdir()
    os.mkfifo(f"mine/{MADE_BY}")
    assert not is_made_by(Path("mine"), MINE)


def test_a_link_to_a_report_is_none() -> None:
    report(Path("mine"))
    Path("link").symlink_to("mine")
    assert not is_made_by(Path("link"), MINE)


def test_a_mark_says_what_there_is_and_by_what_it_was_made() -> None:
    mine = report(Path("mine"))
    (mine / "figures").mkdir()
    (mine / "figures" / "one").touch()
    write_mark(mine, MINE)
    mark = json.loads((mine / MADE_BY).read_text("utf-8"))
    assert (mark["made by"], sorted(mark["files"])) == (MINE, ["figures/one", "page"])
    assert is_made_by(mine, MINE)


def test_empty_is_a_folder_with_nothing_in_it() -> None:
    Path("empty").mkdir()
    Path("file").touch()
    Path("link").symlink_to("empty")
    assert [is_empty(Path(name)) for name in ("empty", "file", "link", "nothing", ".")] == [
        True, False, False, False, False,
    ]  # fmt: skip
