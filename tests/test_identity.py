"""What makes two trials the same: settings, map, seed, and the code that takes part."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from running import environment

import acoexp

PROGRAM = """
from acoexp.identity import cell_identity
from acoexp.settings import resolve
from acoexp import Grid
print(cell_identity(resolve("aco", {}), Grid(((0, 0), (0, 0)))))
"""


def identity_with(folder: Path) -> str:
    """Return a cell's identity as a copy of the package in a folder computes it."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM],
        env=environment({"PYTHONPATH": str(folder)}),
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    return done.stdout.strip()


@pytest.fixture(scope="module")
def copy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package that may be edited."""
    folder = tmp_path_factory.mktemp("copy")
    package = Path(acoexp.__file__).parent
    shutil.copytree(package, folder / "acoexp", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(package.parent / "conf", folder / "acoexp" / "conf")
    return folder


def test_code_that_takes_part_is_in_it_and_other_code_is_not(copy: Path) -> None:
    before = identity_with(copy)
    with (copy / "acoexp/command/main.py").open("a") as file:
        file.write("# a remark\n")
    assert identity_with(copy) == before
    with (copy / "acoexp/strategies/update/ant_cycle.py").open("a") as file:
        file.write("# a remark\n")
    assert identity_with(copy) != before
