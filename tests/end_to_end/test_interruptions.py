"""What goes wrong while a sweep runs: finished trials stay, the table is printed, the status tells."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numba
import pytest
from mlflow import MlflowClient
from running import QUICK, environment, install, records, run_acoexp, trials

posix = pytest.mark.skipif(os.name != "posix", reason="signals and pseudo terminals of POSIX")

PART = '''
from dataclasses import dataclass

from acoexp.colony.compiled import compiled
from acoexp.strategies import Diffusion, Heuristic, Post


@compiled
def forget(colony, own, cells, count):
    return 1


@dataclass(frozen=True, kw_only=True)
class Forgetful(Post):
    """Forgets the whole path but its first cell."""

    kernel = staticmethod(forget)


@compiled
def make_a_list(colony, own, ant, cell, came):
    colony.random[0] = [cell][0]


@dataclass(frozen=True, kw_only=True)
class Listing(Diffusion):
    """Does not compile."""

    kernel = staticmethod(make_a_list)


@dataclass(frozen=True, kw_only=True)
class Raising(Heuristic):
    """Raises."""

    def eta(self, problem):
        raise ZeroDivisionError("too bad")
'''
INTERRUPTING = """
import os, signal, sys

class Interrupting:
    def find_spec(self, name, path=None, target=None):
        if name == "{module}":
            exec("os.kill(os.getpid(), signal.SIGINT)")  # Python has a way of its own to end then

sys.meta_path.insert(0, Interrupting())
"""
"""Sends Ctrl-C when a module is about to be imported."""

ENTRIES = """
[acoexp.diffusion]
listing = faulty_parts:Listing

[acoexp.post]
forgetful = faulty_parts:Forgetful

[acoexp.heuristic]
raising = faulty_parts:Raising
absent = no_such_package:Absent
"""


@pytest.fixture(scope="module")
def plugin(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Return the environment in which a package with faulty parts is installed."""
    site = tmp_path_factory.mktemp("site")
    return install(site, "faulty-parts", ENTRIES, {"faulty_parts/__init__.py": PART})


@pytest.mark.parametrize(
    ("bad", "good", "said"),
    [
        ("post=forgetful", "geometric", "post 'forgetful' of package faulty-parts 1.0 broke its contract"),
        (
            "heuristic=raising",
            "goal_distance",
            "heuristic 'raising' of package faulty-parts 1.0 failed in eta: ZeroDivisionError",
        ),
    ],
)
def test_a_part_that_breaks_its_contract_fails_its_own_jobs_alone(
    bad: str, good: str, said: str, plugin: dict[str, str], tmp_path: Path
) -> None:
    group, _, name = bad.partition("=")
    quick = ("iterations=3", "ants=9")
    ended = run_acoexp(f"{group}={name},{good}", "-m", "seed=0,1", *quick, cwd=tmp_path, env=plugin)
    assert ended.returncode == 1
    *lines, last = [line for line in ended.stderr.splitlines() if line.startswith("acoexp: error: ")]
    assert last == "acoexp: error: 2 of 4 jobs failed; the others are kept"
    assert [
        said in line and f"{group}={name}" in line and f"seed={seed}" in line for seed, line in enumerate(lines)
    ] == [
        True,
        True,
    ]
    assert [said in file.read_text() for file in tmp_path.rglob("failed.txt")] == [True, True]
    assert "Traceback" not in ended.stderr
    assert "2 of 4 trials finished" in ended.stdout
    assert [trial["config"][f"{group}.name"] for trial in trials(tmp_path)] == [good, good]
    client = MlflowClient(f"sqlite:///{tmp_path}/outputs/mlflow.db")
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    failed = {run.data.params["seed"]: run for run in runs if run.info.status == "FAILED"}
    assert failed.keys() == {"0", "1"}
    assert all(said in run.data.tags["reason"] for run in failed.values())


def test_a_part_whose_package_is_broken_is_refused_before_anything_runs(
    plugin: dict[str, str], tmp_path: Path
) -> None:
    ended = run_acoexp("heuristic=goal_distance,absent", "-m", *QUICK, cwd=tmp_path, env=plugin)
    assert ended.returncode == 1
    assert ended.stderr.startswith(
        "acoexp: error: heuristic 'absent' of package faulty-parts 1.0 cannot be imported"
    )
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow_without_jit
@pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")
def test_what_cannot_be_compiled_is_tried_once_and_said_for_each_job(
    plugin: dict[str, str], tmp_path: Path
) -> None:
    ended = run_acoexp("diffusion=listing,none", "-m", "seed=0-2", *QUICK, cwd=tmp_path, env=plugin)
    assert ended.returncode == 1
    assert ended.stderr.count("compiling the colony") <= 2, ended.stderr
    assert ended.stderr.count("must not allocate") == 3, ended.stderr
    assert "3 of 6 trials finished" in ended.stdout


def test_a_broken_package_harms_nobody_who_does_not_use_it(plugin: dict[str, str], tmp_path: Path) -> None:
    ended = run_acoexp("--help", cwd=tmp_path, env=plugin)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "Forgets the whole path" in ended.stdout


@posix
def test_an_interrupted_sweep_keeps_its_finished_trials(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "acoexp", "-m", "seed=0-39", *QUICK]
    process = subprocess.Popen(
        command, cwd=tmp_path, env=environment(), text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    deadline = time.monotonic() + 60.0
    while len(records(tmp_path)) < 3:
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.005)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30.0)
    assert process.returncode == 130
    finished = trials(tmp_path)  # every record that is there can be read
    assert 3 <= len(finished) < 40
    assert f"{len(finished)} of 40 trials finished" in out
    assert "acoexp: interrupted; what was finished is kept" in err
    assert "Traceback" not in err


@posix
def test_ctrl_c_after_all_was_said_changes_nothing(tmp_path: Path) -> None:
    late = "import atexit, os, signal\natexit.register(os.kill, os.getpid(), signal.SIGINT)\n"
    (tmp_path / "sitecustomize.py").write_text(late, encoding="utf-8")
    ended = run_acoexp("seed=1", *QUICK, cwd=tmp_path, env={"PYTHONPATH": str(tmp_path)})
    assert (ended.returncode, "KeyboardInterrupt" in ended.stderr) == (0, False)


@posix
@pytest.mark.parametrize("module", ["acoexp.command.main", "numba", "acoexp.errors"])
def test_ctrl_c_while_the_program_is_read_is_one_line(module: str, tmp_path: Path) -> None:
    """Whatever is being imported then."""
    (tmp_path / "sitecustomize.py").write_text(INTERRUPTING.format(module=module), encoding="utf-8")
    ended = run_acoexp("seed=1", *QUICK, cwd=tmp_path, env={"PYTHONPATH": str(tmp_path)})
    assert (ended.returncode, ended.stdout, ended.stderr) == (130, "", "acoexp: interrupted; nothing was begun\n")


@posix
@pytest.mark.parametrize("module", ["matplotlib", "mlflow"])
def test_a_trial_alone_is_seen_before_what_draws_and_keeps_it_is_read(module: str, tmp_path: Path) -> None:
    (tmp_path / "sitecustomize.py").write_text(INTERRUPTING.format(module=module), encoding="utf-8")
    ended = run_acoexp("iterations=3", "ants=2", cwd=tmp_path, env={"PYTHONPATH": str(tmp_path)})
    assert ended.returncode == 130
    assert ended.stderr.splitlines()[-1] == "acoexp: interrupted; this trial may not be kept"
    *_, row, files, follows = ended.stdout.splitlines()
    assert row.split()[:2] == ["pdg", "fig13"]
    assert files.startswith("files: outputs/runs/")
    assert follows == "pictures follow, then where it is kept"
    assert len(trials(tmp_path)) == 1


@posix
def test_a_progress_bar_shows_on_a_terminal_alone(tmp_path: Path) -> None:
    import pty

    ours, theirs = pty.openpty()
    try:
        ended = subprocess.run(
            [sys.executable, "-m", "acoexp", "-m", "seed=0-9", *QUICK],
            cwd=tmp_path,
            env=environment({"TERM": "xterm"}),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=theirs,
            timeout=60.0,
            check=True,
        )
        shown = os.read(ours, 1 << 16).decode(errors="replace")
    finally:
        os.close(ours)
        os.close(theirs)
    assert "trials" in shown
    assert "/10" in shown
    assert b"\x1b" not in ended.stdout


def test_where_nobody_watches_there_is_no_bar(tmp_path: Path) -> None:
    ended = run_acoexp("-m", "seed=0-1", *QUICK, cwd=tmp_path, env={"TERM": "xterm", "FORCE_COLOR": ""})
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "\x1b" not in ended.stdout


SLOW_TRIAL = """
import acoexp, time
acoexp.solve("fig13", "aco", iterations=1)
print("ready", flush=True)
acoexp.solve("fig13", "aco", iterations=1_000_000, ants=50)
"""


@posix
def test_a_long_trial_can_be_interrupted() -> None:
    process = subprocess.Popen([sys.executable, "-c", SLOW_TRIAL], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stdout.readline() == b"ready\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=20)
    assert b"KeyboardInterrupt" in errors
