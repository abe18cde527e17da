"""Every command and every piece of Python in the README and the docs runs as it stands there."""

from __future__ import annotations

import re
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest
from documented import BLOCK, PAGES, ROOT, run_blocks
from running import environment, run_acoexp

from acoexp.colony import pheromone
from acoexp.colony.scalars import ColonySettings
from acoexp.colony.state import Colony, Trails
from acoexp.parameters import fields_of


@pytest.mark.slow_without_jit
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_block_runs_and_the_pages_that_it_writes_open(
    page: Path, as_a_reader: Path, request: pytest.FixtureRequest
) -> None:
    run_blocks(page, as_a_reader, request)


@pytest.mark.parametrize("page", [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))], ids=lambda p: p.name)
def test_the_files_that_a_page_names_are_there(page: Path) -> None:
    named = re.findall(r"`((?:acoexp|conf|docs|plugins|tests)/[\w./*-]+)`", page.read_text(encoding="utf-8"))
    assert [name for name in named if not any(ROOT.glob(name))] == []


def test_the_readme_begins_with_the_two_commands() -> None:
    first, second = BLOCK.findall((ROOT / "README.md").read_text())[:2]
    assert first[1].strip() == "pip install -e . && python -m acoexp algo=pdg map=env2 -m seed=0-9"
    assert second[1].strip() == 'pip install -e ".[test]" && pytest'


def test_the_contract_names_all_that_kernels_get() -> None:
    page = (ROOT / "docs" / "contract.md").read_text()
    named = set(re.findall(r"`(\w+)`", page.partition("## What a kernel gets")[2].partition("## Pheromone")[0]))
    assert {*Colony._fields, *Trails._fields} <= named
    settings = page.partition("| `settings` | `")[2].partition("|")[0]
    assert [name for name in fields_of(ColonySettings) if name not in settings] == []


def test_the_contract_names_every_way_to_change_pheromone() -> None:
    page = (ROOT / "docs" / "contract.md").read_text()
    own = [value for name, value in vars(pheromone).items() if hasattr(value, "__name__") and name[0] != "_"]
    mine = {getattr(v, "py_func", v).__name__ for v in own if getattr(v, "__module__", "") == pheromone.__name__}
    assert {f"{name}(" for name in mine - {"reset", "refresh"}} <= set(re.findall(r"`(\w+\()", page))


@pytest.mark.slow_without_jit
def test_the_mlflow_ui_of_the_readme_shows_the_experiment(as_a_reader: Path) -> None:
    assert run_acoexp("iterations=5", cwd=as_a_reader).returncode == 0
    shown = next(
        text for _, text in BLOCK.findall((ROOT / "README.md").read_text()) if text.startswith("mlflow ui")
    )
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = f"exec {shown.strip()} --port {port} --workers 1"
    without_helpers = environment({"MLFLOW_SERVER_ENABLE_JOB_EXECUTION": "false"})  # which would outlive it
    server = subprocess.Popen(
        ["bash", "-c", command], cwd=as_a_reader, env=without_helpers, start_new_session=True
    )
    try:
        assert b"acoexp" in _experiments(port)
    finally:
        subprocess.run(["pkill", "-TERM", "-s", str(server.pid)], check=False)
        server.wait(timeout=30)


def _experiments(port: int) -> bytes:
    """Ask the server for its experiments as its page does, once it has come up."""
    address = f"http://127.0.0.1:{port}/ajax-api/2.0/mlflow/experiments/search"
    request = urllib.request.Request(address, b'{"max_results": 10}', {"Content-Type": "application/json"})
    for _ in range(120):
        try:
            with urllib.request.urlopen(request, timeout=5) as answer:
                return bytes(answer.read())
        except OSError:
            time.sleep(0.5)
    raise AssertionError("the server did not come up within a minute")


@pytest.mark.slow_without_jit
@pytest.mark.skipif(shutil.which("g++") is None, reason="its yardstick is a C++ program")
def test_the_speed_benchmark_runs() -> None:
    command = [sys.executable, ROOT / "tests" / "benchmarks", "speed", "--rounds", "1"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    assert "x C++" in done.stdout
