"""What a worker needs: the installed packages, the sweep's folder and the store's address, and nothing else."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from mlflow import MlflowClient
from running import environment, run_acoexp, trials
from servers import until

import acoexp

pytestmark = pytest.mark.slow_without_jit

PART = '''
from dataclasses import dataclass

from acoexp.strategies.diffusion.gaussian import Gaussian


@dataclass(frozen=True, kw_only=True)
class Strange(Gaussian):
    """A stranger's diffusion."""
'''


def stranger(site: Path) -> dict[str, str]:
    """Install a package with a diffusion called strange; return the environment that has it."""
    (site / "strange").mkdir(parents=True)
    (site / "strange" / "__init__.py").write_text(PART, encoding="utf-8")
    (site / "strange-1.0.dist-info").mkdir()
    metadata = "Metadata-Version: 2.1\nName: strange\nVersion: 1.0\n"
    (site / "strange-1.0.dist-info" / "METADATA").write_text(metadata, encoding="utf-8")
    entries = "[acoexp.diffusion]\nstrange = strange:Strange\n"
    (site / "strange-1.0.dist-info" / "entry_points.txt").write_text(entries, encoding="utf-8")
    return {"PYTHONPATH": os.pathsep.join([str(site), *filter(None, [os.environ.get("PYTHONPATH")])])}


def test_nothing_of_the_parents_own_folder(slurm: Mapping[str, str], tmp_path: Path) -> None:
    home = tmp_path / "home"
    (home / "mine" / "study").mkdir(parents=True)
    (home / "mine" / "study" / "slow.yaml").write_text("# @package _global_\nrho: 0.25\n", encoding="utf-8")
    (home / "yard.txt").write_text("S..\n.#.\n..G\n", encoding="utf-8")
    packages = stranger(tmp_path / "site")
    sweep = ["map=file", "map.path=yard.txt", "-cd=mine", "+study=slow", "diffusion=strange", "seed=0,1"]
    places = [f'hydra.sweep.dir="{tmp_path}/it\'s swept"', f"tracking.uri=sqlite:///{tmp_path}/store/mlflow.db"]
    process = subprocess.Popen(
        [sys.executable, "-m", "acoexp", "-m", "engine=slurm", *sweep, *places],
        cwd=home,
        env=environment({**slurm, **packages}),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    until(lambda: process.poll() is not None or any(tmp_path.glob("*swept/.submitit/*.sh")))
    home.rename(tmp_path / "gone")  # as if the workers were on another machine
    out, err = process.communicate(timeout=240.0)
    assert process.returncode == 0, err
    assert "2 of 2 trials finished" in out
    grid = acoexp.Grid([[0, 0, 0], [0, 1, 0], [0, 0, 0]])
    for trial in trials(tmp_path / "it's swept"):
        assert trial["config"]["diffusion.name"] == "strange"
        assert trial["config"]["map.path"] == "yard.txt"
        assert (
            trial["curve"]
            == acoexp.solve(
                grid, "pd", trial["seed"], post="geometric", rho=0.25, update="dual_ant_cycle"
            ).as_dict()["curve"]
        )
    assert len(finished_runs(f"sqlite:///{tmp_path}/store/mlflow.db")) == 2


def test_eight_writers_at_once_lose_nothing_on_a_fresh_store(tmp_path: Path) -> None:
    eight_at_once("sqlite:///outputs/mlflow.db", tmp_path)
    assert finished_runs(f"sqlite:///{tmp_path}/outputs/mlflow.db") == list(range(24))


def test_eight_writers_at_once_lose_nothing_on_a_fresh_postgresql(
    fresh_database: Callable[[str], str], tmp_path: Path
) -> None:
    uri = fresh_database("eight")
    eight_at_once(uri, tmp_path)
    assert finished_runs(uri) == list(range(24))
    assert not list(tmp_path.rglob("*.db"))


def eight_at_once(uri: str, home: Path) -> None:
    """Run eight commands side by side, each with three short trials, to one store."""
    with ThreadPoolExecutor(8) as threads:
        sweeps = [("-m", f"seed={3 * n}-{3 * n + 2}", "iterations=3", f"tracking.uri={uri}") for n in range(8)]
        writers = [threads.submit(run_acoexp, *sweep, cwd=home, timeout=240.0) for sweep in sweeps]
    ended = [writer.result() for writer in writers]
    assert [one.returncode for one in ended] == [0] * 8, [one.stderr for one in ended]


def finished_runs(uri: str) -> list[int]:
    """Return the seeds of all finished runs in a store, sorted."""
    client = MlflowClient(uri)
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    assert {run.info.status for run in runs} == {"FINISHED"}
    return sorted(int(run.data.params["seed"]) for run in runs)
