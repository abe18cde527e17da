"""The kernel cache: compiled once for all processes, and never run after an edit.

What one process does alone is tried out on a loop that compiles in an instant; what it takes several
processes for, on real ones.
"""

from __future__ import annotations

import logging
import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
import pytest

from acoexp.colony.cache import compile_once
from acoexp.colony.cache_folder import cache_root
from acoexp.colony.compiled import compiled
from acoexp.strategies.diffusion.none import stay

pytestmark = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")

COMPILES = "acoexp.colony.cache: compiling the colony"
DAY = 24 * 3600.0

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


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of an empty cache, for this process."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert tmp_path in cache_root().parents
    return cache_root()


def new_loop() -> Any:
    """Return what nobody has compiled yet."""

    @compiled
    def loop(number: float) -> float:
        return number + 1.0

    return loop


def loaded(loop: Any) -> bool:
    """Compile a loop, or load it; tell which."""
    compile_once(loop, (stay, None), (2.0,))
    assert loop(2.0) == 3.0
    return bool(sum(loop.stats.cache_hits.values()))


def kept_files(root: Path) -> list[Path]:
    return [file for file in root.rglob("*") if file.is_file() and file.name != "lock"]


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


def test_what_was_compiled_is_loaded_after_that(root: Path, caplog: pytest.LogCaptureFixture) -> None:
    caplog.set_level(logging.INFO)
    assert not loaded(new_loop())
    assert len(caplog.messages) == len(kept_files(root)) == 1
    assert loaded(new_loop())
    assert len(caplog.messages) == 1


@pytest.mark.parametrize(
    "harm", [lambda kept: b"", lambda kept: kept[:-100], lambda kept: kept[:-1] + bytes([kept[-1] ^ 1])]
)
def test_a_damaged_file_is_made_anew(
    root: Path, harm: Callable[[bytes], bytes], caplog: pytest.LogCaptureFixture
) -> None:
    loaded(new_loop())
    (file,) = kept_files(root)
    file.write_bytes(harm(file.read_bytes()))
    assert not loaded(new_loop())
    assert "damaged" in caplog.text
    assert loaded(new_loop())


def test_where_no_folder_can_be_made_each_process_compiles_for_itself(
    root: Path, caplog: pytest.LogCaptureFixture
) -> None:
    root.parent.write_text("a file where the folder should be")
    assert not loaded(new_loop())
    assert "cannot be used" in caplog.text
    assert not loaded(new_loop())


def test_where_a_file_cannot_be_written_the_compiled_code_still_runs(
    root: Path, caplog: pytest.LogCaptureFixture
) -> None:
    loaded(new_loop())
    (file,) = kept_files(root)
    file.unlink()
    file.mkdir()
    assert not loaded(new_loop())
    assert "cannot be written" in caplog.text
    assert kept_files(root) == []


def test_each_signature_has_a_file_of_its_own(root: Path) -> None:
    for number in (1.0, 1):
        for _ in range(2):
            compile_once(new_loop(), (), (number,))
    assert len(kept_files(root)) == 2


def test_what_nobody_asked_for_in_sixty_days_is_removed(root: Path) -> None:
    for name, age in (("old", 61 * DAY), ("recent", 59 * DAY)):
        (root / name).mkdir(parents=True)
        (root / name / "lock").touch()
        os.utime(root / name, (time.time() - age,) * 2)
    loaded(new_loop())
    assert not (root / "old").exists()
    assert (root / "recent").exists()


def test_what_is_asked_for_stays(root: Path) -> None:
    loaded(new_loop())
    (folder,) = root.iterdir()
    os.utime(folder, (time.time() - 61 * DAY,) * 2)
    assert loaded(new_loop())
    assert time.time() - folder.stat().st_mtime < DAY


@pytest.fixture(scope="module")
def ten(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[tuple[str, int]]]:
    """A cache that ten processes filled that started at once, and their outcomes."""
    cache = tmp_path_factory.mktemp("cache")
    processes = [start(cache, SOLVE.format(imports="", settings={})) for _ in range(10)]
    return cache, [outcome(process) for process in processes]


def test_of_ten_processes_that_start_at_once_one_compiles(ten: tuple[Path, list[tuple[str, int]]]) -> None:
    cache, outcomes = ten
    assert len({printed for printed, _ in outcomes}) == 1
    assert sum(compiles for _, compiles in outcomes) == 1
    assert len(kept_files(cache)) == 1


def test_a_later_process_does_not_compile_and_finds_the_same(ten: tuple[Path, list[tuple[str, int]]]) -> None:
    cache, outcomes = ten
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
