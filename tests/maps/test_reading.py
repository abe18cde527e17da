"""Reading a file of a map: any name, one size at most; what else can be wrong is in test_file.py."""

from __future__ import annotations

from pathlib import Path

import pytest

from acoexp import MapError
from acoexp.maps.reading import LARGEST, read_text


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
