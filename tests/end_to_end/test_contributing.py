"""The contributor's page shows the floors as they are, and its walks lead through files that exist, each once."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "contributing.md").read_text(encoding="utf-8")
WALKS = PAGE.partition("## Three walks")[2].partition("## Where is")[0].split("\n**")[1:]
FILE = re.compile(r"`((?:acoexp|plugins|docs|conf|tests)/[\w/.-]+\.\w+)`")


def test_the_picture_is_what_the_command_prints() -> None:
    printed = subprocess.run(
        [sys.executable, ROOT / "docs" / "floors.py"], capture_output=True, text=True, check=True
    )
    assert f"```\n{printed.stdout}```" in PAGE


def test_there_are_three_walks() -> None:
    assert len(WALKS) == 3


@pytest.mark.parametrize("walk", WALKS, ids=lambda walk: walk.partition("*")[0])
def test_no_walk_comes_to_a_file_twice(walk: str) -> None:
    files = FILE.findall(walk)
    assert len(files) >= 10
    assert len(set(files)) == len(files)


def test_every_file_that_is_named_is_there() -> None:
    assert [file for file in FILE.findall(PAGE) if not (ROOT / file).is_file()] == []


def test_no_chain_of_imports_is_longer_than_eleven_files() -> None:
    assert int(re.search(r"longest chain of imports, (\d+) files", PAGE)[1]) <= 11  # type: ignore[index]
