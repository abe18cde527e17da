"""Kernels on a fresh machine: whoever starts first compiles them, once for all."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numba
import pytest
from running import environment, trials

TOGETHER = 4


@pytest.mark.skipif(numba.config.DISABLE_JIT, reason="nothing is compiled")
def test_four_cold_processes_compile_once(tmp_path: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    cold = environment({"XDG_CACHE_HOME": str(tmp_path_factory.mktemp("cache"))})
    # by -m, which draws nothing: matplotlib's own cache is cold as well
    command = [sys.executable, "-m", "acoexp", "algo=aco", "tracking=none", "iterations=3", "-m"]
    processes = [
        subprocess.Popen(
            command, cwd=tmp_path, env=cold, text=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
        )
        for _ in range(TOGETHER)
    ]
    said = [process.communicate(timeout=120.0)[1] for process in processes]
    assert [process.returncode for process in processes] == [0] * TOGETHER, said
    assert sorted(said) == [""] * (TOGETHER - 1) + ["acoexp: compiling the colony, once for this machine\n"]
    assert len(trials(tmp_path)) == TOGETHER
