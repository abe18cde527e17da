"""The kernel cache between processes: one compiles for all, and an edit anywhere takes effect."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numba
import pytest

pytestmark = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")

COMPILES = "acoexp.kernels.cache: compiling the colony"
SOLVE = """
import logging
logging.basicConfig(level=logging.INFO, format="%(name)s: %(message)s")
import acoexp
{imports}
found = acoexp.solve([[0] * 9] * 7, "aco", seed=1, ants=3, iterations=5, **{settings})
print(found.ant_steps, found.curve_pairs.tolist())
"""

PLUGIN = """
from dataclasses import dataclass

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import set_level
from acoexp.strategies import Diffusion
{imports}

@compiled
def diffuse(colony, own, ant, cell, came):
    set_level(colony, cell * 8, strength())


@dataclass(frozen=True, kw_only=True)
class Eastwards(Diffusion):
    kernel = staticmethod(diffuse)
"""

STRENGTH = """
from acoexp.colony.compiled import compiled


@compiled
def strength():
    return {strength}
"""


def kept_files(folder: Path) -> list[Path]:
    return [file for file in folder.rglob("*") if file.is_file() and file.name != "lock"]


def start(cache: Path, code: str, *packages: Path) -> subprocess.Popen[str]:
    """Start a Python process with a cache of its own and packages of its own."""
    paths = [*map(str, packages), *filter(None, [os.environ.get("PYTHONPATH")])]
    variables = {**os.environ, "XDG_CACHE_HOME": str(cache), "PYTHONPATH": os.pathsep.join(paths)}
    pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    return subprocess.Popen([sys.executable, "-c", code], env=variables, cwd=cache, **pipes)


def outcome(process: subprocess.Popen[str]) -> tuple[str, int]:
    """Wait for a process: what it printed, and how often it compiled."""
    printed, logged = process.communicate(timeout=120)
    assert process.returncode == 0, logged
    return printed, logged.count(COMPILES)


@pytest.fixture(scope="module")
def four(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[tuple[str, int]]]:
    """A cache that four processes filled that started at once, and their outcomes."""
    cache = tmp_path_factory.mktemp("cache")
    processes = [start(cache, SOLVE.format(imports="", settings={})) for _ in range(4)]
    return cache, [outcome(process) for process in processes]


def test_of_four_processes_that_start_at_once_one_compiles(four: tuple[Path, list[tuple[str, int]]]) -> None:
    cache, outcomes = four
    assert len({printed for printed, _ in outcomes}) == 1
    assert sum(compiles for _, compiles in outcomes) == 1
    assert len(kept_files(cache)) == 1


def test_a_later_process_does_not_compile_and_finds_the_same(four: tuple[Path, list[tuple[str, int]]]) -> None:
    cache, outcomes = four
    assert outcome(start(cache, SOLVE.format(imports="", settings={}))) == (outcomes[0][0], 0)


def test_an_edit_anywhere_in_a_plugins_package_takes_effect(tmp_path: Path) -> None:
    package = tmp_path / "plugin"
    package.mkdir()
    (package / "__init__.py").write_text(PLUGIN.format(imports="from plugin.numbers import strength"))
    code = SOLVE.format(imports="import plugin", settings="{'diffusion': plugin.Eastwards()}")
    found = []
    for strength, compiles in ((1.0, 1), (1e9, 1), (1e9, 0), (1.0, 0)):
        (package / "numbers.py").write_text(STRENGTH.format(strength=strength))
        printed, compiled_now = outcome(start(tmp_path, code, tmp_path))
        assert compiled_now == compiles
        found.append(printed)
    assert found[0] == found[3] != found[1] == found[2]


def test_a_kernel_of_a_script_works_and_is_not_kept(tmp_path: Path) -> None:
    own = STRENGTH.format(strength=1e9) + PLUGIN.format(imports="")
    process = start(tmp_path, SOLVE.format(imports=own, settings="{'diffusion': Eastwards()}"))
    printed, _ = outcome(process)
    assert printed
    assert kept_files(tmp_path) == []
