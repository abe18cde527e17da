"""Reading a file of a map: any name, one size at most; what else can be wrong is in test_file.py."""

from __future__ import annotations

from pathlib import Path

import pytest

from acoexp import MapError
from acoexp.maps.reading import LARGEST, LONGEST_SIDE, check_size, read_bytes, read_text


def test_a_file_is_read_whole_with_its_path(tmp_path: Path) -> None:
    (tmp_path / "yard").write_text("\ufeffüç\n", encoding="utf-8")
    assert read_text(str(tmp_path / "yard"), "map.path") == (tmp_path / "yard", "üç\n")


def test_the_key_that_named_it_is_said(tmp_path: Path) -> None:
    with pytest.raises(MapError, match=r"^map\.scenario: expected a readable text file; got "):
        read_text(str(tmp_path), "map.scenario")


def test_one_byte_more_than_a_map_may_have_is_too_much(tmp_path: Path) -> None:
    (tmp_path / "yard").write_bytes(b"." * LARGEST)
    assert len(read_text(str(tmp_path / "yard"), "map.path")[1]) == LARGEST
    (tmp_path / "yard").write_bytes(b"." * (LARGEST + 1))
    with pytest.raises(MapError, match="more than 8 MiB"):
        read_text(str(tmp_path / "yard"), "map.path")


def test_bytes_are_read_as_they_are_up_to_a_limit(tmp_path: Path) -> None:
    (tmp_path / "yard").write_bytes(b"\xff\0")
    assert read_bytes(str(tmp_path / "yard"), "map.path", "NumPy file", 2) == (tmp_path / "yard", b"\xff\0")
    with pytest.raises(MapError, match=r"^map\.path: expected a readable NumPy file; got "):
        read_bytes(str(tmp_path / "yard"), "map.path", "NumPy file", 1)


def test_a_map_has_so_many_rows_columns_and_cells_at_most() -> None:
    check_size(2048, 2048, "yard")
    check_size(1, LONGEST_SIDE, "yard")
    for rows, cols in ((2048, 2049), (1, LONGEST_SIDE + 1), (LONGEST_SIDE + 1, 1), (10**9, 10**9)):
        with pytest.raises(MapError, match=f"^map yard: expected at most .*; got {rows} x {cols}$"):
            check_size(rows, cols, "yard")
