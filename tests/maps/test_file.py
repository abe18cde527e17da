"""Maps from files: what can be wrong with a path, and that every message names the file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, MapError, SettingsError
from acoexp.maps.file import MapFile
from acoexp.maps.npy import LARGEST_ARRAY
from acoexp.maps.reading import LARGEST
from acoexp.parameters import build

ART = "; moves: free\n..#\n...\n#..\n"


@pytest.fixture
def yard(tmp_path: Path) -> Path:
    """Return a map's file."""
    path = tmp_path / "yard.txt"
    path.write_text(ART, encoding="utf-8")
    return path


def load(path: Any, **options: Any) -> Grid:
    """Load a map as the command line and Python do, its parameters checked."""
    grid: Grid = build(MapFile, {"path": str(path), **options}, "map.").load()
    return grid


def refusal(path: Any, **options: Any) -> str:
    """Return the message with which a file is refused."""
    with pytest.raises(MapError) as caught:
        load(path, **options)
    return str(caught.value)


def test_a_map_is_called_like_its_file(yard: Path) -> None:
    grid = load(yard)
    assert (grid.name, grid.shape, grid.moves) == ("yard.txt", (3, 3), "free")


def test_parameters_say_what_the_file_does_not(yard: Path) -> None:
    grid = load(yard, start=[1, 0], goal=(1, 2), moves="no_cut")
    assert (grid.start, grid.goal, grid.moves) == ((1, 0), (1, 2), "no_cut")


def test_a_relative_path_starts_in_the_working_directory(yard: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(yard.parent)
    assert load("yard.txt").shape == (3, 3)


def test_a_tilde_stands_for_the_home_directory(yard: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(yard.parent))
    monkeypatch.setenv("USERPROFILE", str(yard.parent))
    assert load("~/yard.txt").shape == (3, 3)


@pytest.mark.parametrize("content", [ART.replace("\n", "\r\n"), ART + "\n\n\n", ART.rstrip("\n")])
def test_line_ends_and_trailing_blank_lines_do_not_matter(yard: Path, content: str) -> None:
    yard.write_bytes(content.encode())
    assert load(yard).digest == Grid([[0, 0, 1], [0, 0, 0], [1, 0, 0]], moves="free").digest


def test_a_byte_order_mark_does_not_matter(yard: Path) -> None:
    yard.write_bytes(b"\xef\xbb\xbf" + ART.encode())
    assert load(yard).moves == "free"


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    path = str(tmp_path / "nowhere.txt")
    assert refusal(path) == f"map.path: expected a readable text file; got {path!r} (No such file or directory)"


def test_what_is_no_file_is_refused_by_its_kind_and_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert Path("/proc/kmsg").exists() is False or refusal("/proc/kmsg")  # which waits for what it has not got yet
    kinds = {tmp_path: "a folder", tmp_path / "pipe": "a pipe", Path("/dev/zero"): "a device"}
    for path, kind in kinds.items():
        assert refusal(path) == f"map.path: expected a readable text file; got {str(path)!r} ({kind})"


def test_a_file_that_is_too_large_for_a_map_is_refused_before_it_is_read(yard: Path) -> None:
    with yard.open("wb") as file:
        file.truncate(100 * 10**6)
    assert refusal(yard).endswith("(more than 8 MiB, the most that a map may have)")


def test_a_file_of_numpys_is_known_by_its_name(tmp_path: Path) -> None:
    np.save(tmp_path / "yard.npy", np.array([[0, 0, 1], [2, 0, 3], [1, 0, 0]], dtype=float))
    grid = load(tmp_path / "yard.npy", moves="free")
    assert (grid.name, grid.start, grid.goal, grid.moves) == ("yard.npy", (1, 0), (1, 2), "free")
    assert grid.digest == Grid(grid.obstacles, start=(1, 0), goal=(1, 2), moves="free").digest
    (tmp_path / "yard.NPY").write_text(ART, encoding="utf-8")
    assert refusal(tmp_path / "yard.NPY").startswith("map yard.NPY: expected an array as numpy.save writes it")
    assert refusal(tmp_path / "no.npy").startswith("map.path: expected a readable NumPy file; got ")


def test_an_array_of_the_most_cells_is_read_and_one_of_more_bytes_is_not(tmp_path: Path) -> None:
    np.save(tmp_path / "yard.npy", np.zeros((2048, 2048)))
    assert (tmp_path / "yard.npy").stat().st_size <= LARGEST_ARRAY
    with (tmp_path / "yard.npy").open("wb") as file:
        file.truncate(100 * 10**6)
    assert refusal(tmp_path / "yard.npy").endswith("(more than 32 MiB, the most that a map may have)")


def test_a_map_of_2048_by_2048_cells_is_not_too_large() -> None:
    assert 2048 * len(". " * 2048) <= LARGEST


def test_a_word_that_is_as_long_as_a_book_is_not_repeated(yard: Path) -> None:
    yard.write_text(f"0 {'1' * 100_000}\n", encoding="utf-8")
    assert len(refusal(yard)) < 400


@pytest.mark.parametrize("name", ["q?x=1", "a%2Fb", "[run]", "$^$", "${b}", "a\\'b", "2024.05.01", " a (1) 中"])
def test_a_file_may_have_any_name_and_its_map_has_the_same(yard: Path, name: str) -> None:
    yard.rename(yard.with_name(name))
    assert load(yard.with_name(name)).name == name


@pytest.mark.parametrize(("name", "seen"), [("a\x1b[31m", r"a\x1b[31m"), ("a\nb", r"a\nb"), ("\udcff", r"\udcff")])
def test_what_a_terminal_would_obey_is_no_part_of_a_maps_name(yard: Path, name: str, seen: str) -> None:
    yard.rename(yard.with_name(name))
    assert load(yard.with_name(name)).name == seen


def test_an_unreadable_file_is_named(yard: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Raised by hand: an administrator, whom many containers run as, may read everything."""

    def denied(*args: Any, **kwargs: Any) -> str:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("acoexp.maps.reading.os.open", denied)
    assert refusal(yard) == f"map.path: expected a readable text file; got {str(yard)!r} (Permission denied)"


@pytest.mark.parametrize("content", [b"\x89PNG\r\n\x1a\n\x00\xff", ART.encode("utf-16")])
def test_a_binary_file_is_no_map(yard: Path, content: bytes) -> None:
    yard.write_bytes(content)
    assert refusal(yard) == f"map.path: expected a text file in UTF-8; got {str(yard)!r}"


@pytest.mark.parametrize(
    ("content", "complaint"),
    [
        ("", "got an empty text"),
        ("..\n.\n", "row 2 has 1 cells; expected 2"),
        ("..\n.\x00\n", "row 2, column 2: expected one of . # S G; got '\\x00'"),
        (".#\n#.\n", "no way leads from start (0, 0) to goal (1, 1)"),
    ],
)
def test_a_file_that_shows_no_map_is_named(yard: Path, content: str, complaint: str) -> None:
    yard.write_text(content, encoding="utf-8")
    message = refusal(yard)
    assert message.startswith("map yard.txt: ")
    assert complaint in message


def test_an_unknown_rule_names_the_file_that_declares_it(yard: Path) -> None:
    yard.write_text("; moves: sideways\n...\n", encoding="utf-8")
    message = refusal(yard)
    assert "yard.txt" in message
    assert "'sideways'" in message


@pytest.mark.parametrize("path", ["~nobody-of-this-name/yard.txt", "yard\0.txt"])
def test_a_path_that_cannot_be_one_is_refused(path: str) -> None:
    assert repr(path) in refusal(path)


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ({"path": "???"}, "map.path: expected a text; got nothing"),
        ({"path": None}, "map.path: expected a text; got nothing"),
        ({"path": 5}, "map.path: expected a text; got 5"),
        ({"start": [1]}, r"map.start: expected a pair \[row, column\]; got \[1\]"),
        ({"start": [0.5, 1]}, r"map.start: expected a pair \[row, column\]; got \[0.5, 1\]"),
        ({"goal": "12"}, r"map.goal: expected a pair \[row, column\]; got '12'"),
        ({"moves": "sideways"}, "map.moves: expected one of: free, no_squeeze, no_cut, four; got 'sideways'"),
        ({"file": "x"}, "map.file is not a known key; expected one of: map.path, map.start, map.goal, map.moves"),
    ],
)
def test_parameters_are_checked(options: dict[str, Any], complaint: str) -> None:
    with pytest.raises(SettingsError, match=complaint):
        build(MapFile, {"path": "yard.txt", **options}, "map.")


def test_a_path_must_be_given() -> None:
    with pytest.raises(SettingsError, match=r"map.path: expected a text; got nothing"):
        build(MapFile, {}, "map.")
