"""What makes two trials the same: settings, map, seed, and the code that takes part."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import grimp
import pytest
from running import environment

import acoexp
from acoexp.tracking.identity import TAKES_PART

PROGRAM = """
from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.tracking.setup import Setup
print(Setup.of(resolve("aco", {}), Grid(((0, 0), (0, 0)))).configuration_id)
"""


def identity_with(folder: Path) -> str:
    """Return a configuration's identity as a copy of the package in a folder computes it."""
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


def edited(copy: Path, file: str) -> str:
    """Return the identity after a remark was added to a file of the copy."""
    with (copy / "acoexp" / file).open("a", encoding="utf-8") as text:
        text.write("# a remark\n")
    return identity_with(copy)


@pytest.mark.parametrize(
    "file",
    ["colony/pheromone.py", "grid/field.py", "strategies/update/ant_cycle.py", "trial/batch.py"],
    ids=lambda file: file.partition("/")[0],
)
def test_a_line_in_a_folder_that_takes_part_makes_another_identity(copy: Path, file: str) -> None:
    before = identity_with(copy)
    assert edited(copy, file) != before


def test_a_line_elsewhere_leaves_it_as_it_is(copy: Path) -> None:
    before = identity_with(copy)
    assert edited(copy, "command/main.py") == before
    assert edited(copy, "registry/resolve.py") == before


def test_all_that_takes_part_imports_lies_in_it_or_checks_what_it_is_given() -> None:
    graph = grimp.build_graph("acoexp", cache_dir=None)
    allowed = {*TAKES_PART, "errors", "parameters"}
    for room in TAKES_PART:
        modules = {f"acoexp.{room}", *graph.find_descendants(f"acoexp.{room}")}
        imported = {found for module in modules for found in graph.find_modules_directly_imported_by(module)}
        assert {found.split(".")[1] for found in imported} <= allowed
