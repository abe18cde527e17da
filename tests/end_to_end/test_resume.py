"""Sweeps that are killed, that run twice at once, and whose parts fail: no finished trial is lost or doubled."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from mlflow import MlflowClient
from mlflow.entities import Run
from running import environment, records, run_acoexp

from acoexp import solve_many

pytestmark = [
    pytest.mark.slow_without_jit,
    pytest.mark.skipif(os.name != "posix", reason="signals of POSIX"),
]

SMALL = ("algo=aco", "iterations=6", "ants=3")
KILLS = 6


def runs_in(home: Path) -> list[Run]:
    """Return all runs in the store; none before there is one."""
    client = MlflowClient(f"sqlite:///{home}/outputs/mlflow.db")
    experiment = client.get_experiment_by_name("acoexp")
    return list(client.search_runs([experiment.experiment_id])) if experiment is not None else []


def finished(home: Path) -> list[Run]:
    """Return the runs that are finished."""
    return [run for run in runs_in(home) if run.info.status == "FINISHED"]


def start(*args: str, home: Path) -> subprocess.Popen[str]:
    """Start the command in the background, with all that it starts in one group."""
    return subprocess.Popen(
        [sys.executable, "-m", "acoexp", *args],
        cwd=home,
        env=environment(),
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )


def test_a_sweep_killed_at_random_moments_ends_up_whole(tmp_path: Path) -> None:
    sweep = ("-m", "seed=0-199", *SMALL)
    seen: set[str] = set()
    grew = 0
    for _ in range(KILLS):
        there = len(records(tmp_path))
        process = start(*sweep, home=tmp_path)
        deadline = time.monotonic() + 120.0
        while len(records(tmp_path)) == there:
            assert process.poll() is None, process.communicate()[1]
            assert time.monotonic() < deadline
            time.sleep(0.005)
        time.sleep(random.uniform(0.0, 1.5))
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate(timeout=30.0)
        now = {run.info.run_id for run in finished(tmp_path)}
        assert seen <= now  # what was finished stays
        grew += seen < now
        seen = now
    assert grew >= KILLS // 2
    ended = run_acoexp(*sweep, cwd=tmp_path, timeout=240.0)
    assert ended.returncode == 0, ended.stderr
    assert f"acoexp: {len(seen)} of 200 trials found in the store" in ended.stderr
    undisturbed = solve_many("fig13", "aco", range(200), iterations=6, ants=3)
    runs = {int(run.data.params["seed"]): run.data.metrics for run in finished(tmp_path)}
    assert len(finished(tmp_path)) == len(runs) == 200
    for result in undisturbed:
        metrics = runs[result.seed]
        for name in ("x1", "x2", "x3"):
            assert metrics.get(name, 0) == getattr(result, name)
        for name in ("l1", "l2"):
            assert metrics.get(name, "none") == (
                getattr(result, name) if getattr(result, name) == getattr(result, name) else "none"
            )
        assert metrics["lost_ants"] == result.lost_ants.sum()
    assert {run.info.status for run in runs_in(tmp_path)} <= {"FINISHED", "FAILED"}


def test_a_batch_that_is_killed_goes_on_from_what_it_kept(tmp_path: Path) -> None:
    batch = ("algo=aco", "seeds=0-19999", "iterations=60")
    process = start(*batch, home=tmp_path)
    deadline = time.monotonic() + 120.0
    while not list(tmp_path.glob("outputs/artifacts/*/artifacts/trials/00001.npz")):
        assert process.poll() is None, process.communicate()[1]
        assert time.monotonic() < deadline
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate(timeout=30.0)
    ended = run_acoexp("algo=aco", "seeds=0-299", "iterations=60", cwd=tmp_path)
    assert "aco on fig13: 300 of 300 trials found in the store" in ended.stderr
    (left,) = (run for run in runs_in(tmp_path) if run.info.status != "FINISHED")
    assert (left.info.status, left.data.params["seeds"]) == ("FAILED", "0-19999")
    (run,) = finished(tmp_path)
    results = solve_many("fig13", "aco", range(300), iterations=60)
    assert run.data.metrics["x1"] == sum(r.x1 for r in results) / 300


def test_two_sweeps_at_once_leave_one_finished_run_for_each_trial(tmp_path: Path) -> None:
    sweep = ("-m", "seed=0-19", *SMALL)
    both = [start(*sweep, home=tmp_path) for _ in range(2)]
    said = [process.communicate(timeout=240.0)[1] for process in both]
    assert [process.returncode for process in both] == [0, 0], said
    assert sorted(int(run.data.params["seed"]) for run in runs_in(tmp_path)) == list(range(20))
    assert {run.info.status for run in runs_in(tmp_path)} == {"FINISHED"}


def test_a_sweep_that_is_all_there_does_not_wait_for_mlflow(tmp_path: Path) -> None:
    sweep = ("-m", "seed=0-2", *SMALL)
    first = run_acoexp(*sweep, cwd=tmp_path)
    again = run_acoexp(*sweep, cwd=tmp_path, env={"PYTHONPROFILEIMPORTTIME": "1"})
    assert (first.returncode, again.returncode) == (0, 0)
    assert "acoexp: 3 of 3 trials found in the store" in again.stderr
    assert "acoexp.tracking.mlflow.lookup" in again.stderr
    assert "mlflow.tracking\n" not in again.stderr
