"""The same sweep through every engine: what each trial finds is bit for bit what ``acoexp.solve`` finds here."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import pytest
from mlflow import MlflowClient
from running import run_acoexp, trials

import acoexp

pytestmark = pytest.mark.slow_without_jit

YARD = "S...#....\n.##.#.##.\n.#.....#.\n...###...\n.#.....#G\n"
SEEDS = range(3)
# workers of a cluster do not start in our folder: Ray's start in its own, Slurm's wherever we say
ENGINES = {
    "basic": (),
    "joblib": ("engine=joblib",),
    "slurm": ("engine=slurm", "+hydra.launcher.additional_parameters.chdir=/"),
    "ray": ("engine=ray",),
}


@pytest.fixture(params=ENGINES)
def engine(request: pytest.FixtureRequest) -> tuple[tuple[str, ...], Mapping[str, str]]:
    """An engine's arguments, and the environment in which it is at hand."""
    environment = {} if request.param == "basic" else request.getfixturevalue(request.param)
    return ENGINES[request.param], environment


def test_every_engine_finds_what_a_trial_in_this_process_finds(
    engine: tuple[tuple[str, ...], Mapping[str, str]], tmp_path: Path
) -> None:
    arguments, environment = engine
    yard = tmp_path / "yard.txt"
    yard.write_text(YARD, encoding="utf-8")
    sweep = ("map=file", "map.path=yard.txt", "algo=aco,pdg", f"seed=0-{SEEDS[-1]}")
    ended = run_acoexp("-m", *arguments, *sweep, cwd=tmp_path, env=environment, timeout=240.0)
    assert ended.returncode == 0, ended.stderr
    assert "6 of 6 trials finished" in ended.stdout
    found = {(trial["algo"], trial["seed"]): trial for trial in trials(tmp_path)}
    for algo in ("aco", "pdg"):
        for seed in SEEDS:
            here = json.loads(json.dumps(acoexp.solve(yard, algo=algo, seed=seed).as_dict()))
            assert {key: found[algo, seed][key] for key in here} == here
    client = MlflowClient(f"sqlite:///{tmp_path}/outputs/mlflow.db")
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    stored = {(run.data.params["algo"], int(run.data.params["seed"])): run.data.metrics for run in runs}
    assert len(runs) == len(stored) == len(found)
    for key, metrics in stored.items():
        assert metrics.items() >= {name: found[key][name] for name in ("x1", "x3", "l1", "l2")}.items()
