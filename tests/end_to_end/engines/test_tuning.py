"""Tuning by ``hydra/sweeper=optuna``: whole commands, with studies in databases that later ones go on with."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from running import environment, install, records, refusal, run_acoexp, trials
from servers import until

optuna = pytest.importorskip("optuna")
pytestmark = pytest.mark.slow_without_jit

TUNE = ("-m", "hydra/sweeper=optuna", "hydra.sweeper.n_trials=4", "hydra.sweeper.sampler.seed=1")
SHORT = ("iterations=4", "ants=9", "tracking=none")
RHO = "rho=interval(0.1,0.9)"
MOODY = '''
from dataclasses import dataclass

from acoexp.strategies.diffusion.gaussian import Gaussian


@dataclass(frozen=True, kw_only=True)
class Moody(Gaussian):
    """A stranger's diffusion, which works at the ends of an interval and not within."""

    def prepare(self, problem):
        if 0.1 < problem.settings.rho < 0.9:
            raise ValueError("not today")
        return super().prepare(problem)
'''


def tune(home: Path, *arguments: str, **options: Any) -> subprocess.CompletedProcess[str]:
    """Run a small study that ends well."""
    ended = run_acoexp(*TUNE, *arguments, *SHORT, cwd=home, **options)
    assert ended.returncode == 0, ended.stderr
    return ended


def best(home: Path) -> dict[str, Any]:
    """Return what the one sweep below a folder says was best."""
    (file,) = home.rglob("optimization_results.yaml")
    found: dict[str, Any] = yaml.safe_load(file.read_text(encoding="utf-8"))
    return found


def chosen(home: Path) -> list[str]:
    """Return the values of rho that jobs below a folder were told, in the order of their folders' names."""
    return [json.loads(file.read_text(encoding="utf-8"))["config"]["rho"] for file in records(home)]


def kept(storage: str, state: str = "COMPLETE") -> list[float]:
    """Return the values of rho of a study's trials in a state."""
    every = optuna.load_study(study_name="s", storage=storage).trials
    return [trial.params["rho"] for trial in every if trial.state.name == state]


def test_the_objective_of_a_trial_is_its_best_length(tmp_path: Path) -> None:
    ended = tune(tmp_path, RHO, "algo=choice(aco,pdg)")
    found = {trial["config"]["rho"]: trial for trial in trials(tmp_path)}
    assert len(found) == 4
    results = best(tmp_path)
    assert results["best_value"] == min(trial["l1"] for trial in found.values())
    trial = found[str(results["best_params"]["rho"])]
    assert (trial["algo"], trial["l1"]) == (results["best_params"]["algo"], results["best_value"])
    assert "4 of 4 trials finished" in ended.stdout
    assert ended.stderr == ""


def test_the_objective_of_a_batch_is_the_mean_over_its_seeds(tmp_path: Path) -> None:
    tune(tmp_path, RHO, "seeds=0-4,7")
    batches = [json.loads(file.read_text(encoding="utf-8")) for file in tmp_path.rglob("batch.json")]
    means = {batch["config"]["rho"]: batch["means"]["l1"] for batch in batches}
    assert len(means) == 4
    results = best(tmp_path)
    assert results["best_value"] == pytest.approx(min(means.values()), rel=1e-12)
    assert means[str(results["best_params"]["rho"])] == min(means.values())


def test_a_seed_repeats_a_study_also_with_two_jobs_at_once(joblib: object, tmp_path: Path) -> None:
    for name, engine in (("one", "basic"), ("two", "joblib")):
        (tmp_path / name).mkdir()
        tune(tmp_path / name, RHO, f"engine={engine}", "hydra.sweeper.n_jobs=2", env={})
    assert chosen(tmp_path / "one") == chosen(tmp_path / "two")
    assert best(tmp_path / "one")["best_params"] == best(tmp_path / "two")["best_params"]


def test_a_second_command_goes_on_with_the_study_in_the_same_folder(tmp_path: Path) -> None:
    go_on(tmp_path, f"sqlite:///{tmp_path}/studies/study.db", "hydra.sweeper.storage=sqlite:///studies/study.db")


def test_a_second_command_goes_on_with_the_study_on_postgresql(
    fresh_database: Callable[[str], str], tmp_path: Path
) -> None:
    storage = fresh_database("study").replace("acoexp@", "acoexp:s3cret@")
    said = go_on(tmp_path, storage, f"hydra.sweeper.storage={storage}")
    files = [file for file in tmp_path.rglob("*") if file.is_file()]
    assert [file.name for file in files if "s3cret" in file.read_text("utf-8", errors="replace")] == []
    assert "s3cret" not in said


def go_on(home: Path, storage: str, key: str) -> str:
    """Run two commands with one study, the second with a store of trials; return all that they printed."""
    arguments = (RHO, key, "hydra.sweeper.study_name=s", "hydra.sweep.dir=sweep")
    first = tune(home, *arguments)
    before = best(home)["best_value"]
    second = run_acoexp(*TUNE, *arguments, *SHORT[:2], cwd=home)  # MLflow keeps these
    assert second.returncode == 0, second.stderr
    assert "study s goes on after 4 trials" in second.stderr
    assert sorted(record.parent.name for record in records(home)) == [str(number) for number in range(8)]
    assert len({*kept(storage)}) == 8
    assert sorted(map(str, kept(storage))) == sorted(chosen(home))
    assert best(home)["best_value"] == min(trial["l1"] for trial in trials(home)) <= before
    return first.stdout + first.stderr + second.stdout + second.stderr


def test_a_killed_command_loses_nothing_that_was_told(tmp_path: Path) -> None:
    storage = f"sqlite:///{tmp_path}/study.db"
    arguments = (RHO, f"hydra.sweeper.storage={storage}", "hydra.sweeper.study_name=s", "hydra.sweep.dir=sweep")
    process = subprocess.Popen(
        [sys.executable, "-m", "acoexp", *TUNE, *arguments, *SHORT, "hydra.sweeper.n_trials=100000"],
        cwd=tmp_path,
        env=environment(),
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    until(lambda: len(records(tmp_path)) >= 5 or process.poll() is not None)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    before = kept(storage)
    assert len(before) >= 3
    running = kept(storage, "RUNNING")
    tune(tmp_path, *arguments)
    after = kept(storage)
    assert after[: len(before)] == before
    assert len(after) == len(before) + 4
    assert kept(storage, "RUNNING") == running
    assert best(tmp_path)["best_value"] <= min(trial["l1"] for trial in trials(tmp_path))


def test_two_commands_at_once_share_a_study(tmp_path: Path) -> None:
    storage = f"sqlite:///{tmp_path}/study.db"
    command = [sys.executable, "-m", "acoexp", *TUNE[:3], RHO, *SHORT, f"hydra.sweeper.storage={storage}"]
    both = [
        subprocess.Popen(
            [*command, "hydra.sweeper.study_name=s", f"hydra.sweeper.sampler.seed={seed}"],
            cwd=tmp_path,
            env=environment(),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        for seed in (1, 2)
    ]
    said = [process.communicate(timeout=240.0)[1] for process in both]
    assert [process.returncode for process in both] == [0, 0], said
    assert len({*kept(storage)}) == 8


def test_where_no_ant_arrives_a_study_ends_as_any(tmp_path: Path) -> None:
    lost = ("algo=aco", "map=env1", "seed=4", "ants=1", "iterations=1", "tracking=none")
    ended = run_acoexp(*TUNE, RHO, *lost, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert "in 4 of 4 trials no ant ever reached the goal" in ended.stdout
    assert best(tmp_path)["best_value"] == float("inf")


def test_as_many_jobs_may_fail_as_are_said_to(tmp_path: Path) -> None:
    stranger = install(
        tmp_path / "site", "moody", "[acoexp.diffusion]\nmoody = moody:Moody\n", {"moody/__init__.py": MOODY}
    )
    storage = f"sqlite:///{tmp_path}/study.db"
    study = (RHO, "diffusion=moody", f"hydra.sweeper.storage={storage}", "hydra.sweeper.study_name=s")
    ended = run_acoexp(*TUNE, *study, *SHORT, cwd=tmp_path, env=stranger)
    assert ended.returncode == 1
    *lines, last = ended.stderr.splitlines()
    assert last == "acoexp: error: 2 of 2 jobs failed; the others are kept"
    assert [line.partition(": diffusion")[0] for line in lines] == [
        f"acoexp: error: rho={rho} diffusion=moody {' '.join(SHORT)}" for rho in kept(storage, "FAIL")
    ]
    assert all("not today" in line for line in lines)
    ended = run_acoexp(*TUNE, *study, *SHORT, "hydra.sweeper.max_failure_rate=1", cwd=tmp_path, env=stranger)
    assert ended.returncode == 0
    assert len(ended.stderr.splitlines()) == 1 + 4
    assert len(kept(storage, "FAIL")) == 6


def test_a_grid_runs_every_combination_once(tmp_path: Path) -> None:
    grid = ("-m", "hydra/sweeper=optuna", "hydra/sweeper/sampler=grid", "rho=0.1,0.5", "ants=range(2,4)")
    ended = run_acoexp(*grid, "iterations=4", "tracking=none", cwd=tmp_path)
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "4 of 4 trials finished" in ended.stdout
    found = [(trial["config"]["rho"], trial["config"]["ants"]) for trial in trials(tmp_path)]
    assert found == [("0.1", "2"), ("0.1", "3"), ("0.5", "2"), ("0.5", "3")]


def test_a_space_that_jobs_do_not_take_is_refused_before_anything_runs(tmp_path: Path) -> None:
    storage = "hydra.sweeper.storage=sqlite:///study.db"
    said = refusal(*TUNE, "rho=interval(0.5,1.5)", storage, "tracking=none", cwd=tmp_path)
    assert said == "rho: expected a number from 0 to 1; got 1.5"
