"""Kernels on a fresh machine: compiled once whoever starts first, and made anew where they are damaged."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numba
import pytest
from running import environment, run_acoexp, trials

pytestmark = pytest.mark.skipif(numba.config.DISABLE_JIT, reason="nothing is compiled")

COMMAND = ("algo=aco", "tracking=none", "iterations=3", "ants=2", "-m")
TOGETHER = 10


@pytest.fixture(scope="module")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return an empty folder for caches."""
    return tmp_path_factory.mktemp("cache")


def start_all(cache: Path, home: Path) -> Iterator[subprocess.Popen[str]]:
    """Start processes that all want one kernel."""
    for _ in range(TOGETHER):
        yield subprocess.Popen(
            [sys.executable, "-m", "acoexp", *COMMAND],
            cwd=home,
            env=environment({"XDG_CACHE_HOME": str(cache)}),
            text=True,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
        )


def test_ten_cold_processes_compile_once(cache: Path, tmp_path: Path) -> None:
    processes = list(start_all(cache, tmp_path))
    said = [process.communicate(timeout=120.0)[1] for process in processes]
    assert [process.returncode for process in processes] == [0] * TOGETHER, said
    assert sorted(said) == [""] * (TOGETHER - 1) + ["acoexp: compiling the colony, once for this machine\n"]
    assert len(trials(tmp_path)) == TOGETHER


def test_a_damaged_cache_is_made_anew(cache: Path, tmp_path: Path) -> None:
    files = [path for path in cache.rglob("*") if path.is_file() and path.stat().st_size]
    assert files  # left by the test above, or else there is nothing to damage
    for file in files:
        file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    ended = run_acoexp(*COMMAND, cwd=tmp_path, env={"XDG_CACHE_HOME": str(cache)})
    assert ended.returncode == 0, ended.stderr
    assert "damaged" in ended.stderr
    assert len(trials(tmp_path)) == 1
