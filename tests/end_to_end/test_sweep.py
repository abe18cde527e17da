"""A tracked sweep of ten seeds: what is in the store, what is on disk, and that a second one is the same."""

from __future__ import annotations

import subprocess
from itertools import accumulate
from pathlib import Path
from typing import Any, NamedTuple

import numba
import pytest
import yaml
from mlflow import MlflowClient
from mlflow.entities import Run
from running import QUICK, run_acoexp, trials

from acoexp.trial.features import NAMES

pytestmark = pytest.mark.skipif(
    numba.config.DISABLE_JIT, reason="twenty full trials on kernels that are not compiled"
)

METRICS = {*NAMES, "optimum", "any_angle_optimum", "seconds", "cycle_length", "best_length"}
CYCLES = list(range(1, 201))


class Sweep(NamedTuple):
    """What one sweep left behind."""

    ended: subprocess.CompletedProcess[str]
    folder: Path
    runs: dict[int, Run]
    client: MlflowClient

    def curve(self, seed: int, name: str = "cycle_length") -> list[tuple[int, float]]:
        """Return the curve of a trial from the store, as (cycle, length)."""
        history = self.client.get_metric_history(self.runs[seed].info.run_id, name)
        return sorted((point.step, point.value) for point in history)


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the working directory of both sweeps."""
    return tmp_path_factory.mktemp("sweeps")


def run_sweep(home: Path, *args: str) -> Sweep:
    """Run a sweep and gather what was not there before it."""
    folders = set(home.glob("outputs/sweeps/*/*"))
    old = {run.info.run_id for run in runs_in(home)} if folders else set()
    ended = run_acoexp(*args, cwd=home)
    assert ended.returncode == 0, ended.stderr
    (folder,) = set(home.glob("outputs/sweeps/*/*")) - folders
    new = [run for run in runs_in(home) if run.info.run_id not in old]
    assert len(new) == 10
    return Sweep(ended, folder, {int(run.data.params["seed"]): run for run in new}, client_of(home))


def client_of(home: Path) -> MlflowClient:
    """Open the store that lies where the command puts it."""
    return MlflowClient(f"sqlite:///{home}/outputs/mlflow.db")


def test_a_range_of_a_parts_whole_number_is_a_sweep_over_it(tmp_path: Path) -> None:
    given = ("map=random", "map.size=[8,8]", "algo=aco", "map.seed=0-2,7")
    ended = run_acoexp(*given, "-m", *QUICK, cwd=tmp_path)
    assert ended.returncode == 0, ended.stderr
    (folder,) = tmp_path.glob("outputs/sweeps/*/*")
    configs = [yaml.safe_load(path.read_text()) for path in folder.glob("*/config.yaml")]
    assert sorted(config["map"]["seed"] for config in configs) == [0, 1, 2, 7]
    assert len(trials(folder)) == 4
    told = run_acoexp(*given, *QUICK, cwd=tmp_path)
    assert "map.seed=0-2,7: several values; add -m to run them all" in told.stderr
    told = run_acoexp("map=random", "map.seed=9-0", "-m", *QUICK, cwd=tmp_path)
    assert "map.seed: expected a range from low to high, such as 0-9; got '9-0'" in told.stderr


def runs_in(home: Path) -> list[Run]:
    """Return all runs in the store."""
    client = client_of(home)
    experiment = client.get_experiment_by_name("acoexp")
    return list(client.search_runs([experiment.experiment_id]))


@pytest.fixture(scope="module")
def sweep(home: Path) -> Sweep:
    """Run the sweep in the form that the README opens with."""
    return run_sweep(home, "algo=pdg", "map=env2", "-m", "seed=0-9")


@pytest.fixture(scope="module")
def again(home: Path, sweep: Sweep) -> Sweep:
    """Run the same seeds once more, said in another order, and all of them though they are there."""
    return run_sweep(home, "seed=0-4,5-9", "--multirun", "map=env2", "algo=pdg", "resume=false")


def test_each_seed_has_one_finished_run(sweep: Sweep) -> None:
    assert sorted(sweep.runs) == list(range(10))
    assert {run.info.status for run in sweep.runs.values()} == {"FINISHED"}


def test_runs_made_anew_take_the_place_of_the_old_ones(home: Path, again: Sweep) -> None:
    assert {run.info.run_id for run in runs_in(home)} == {run.info.run_id for run in again.runs.values()}


def test_each_run_has_all_metrics_and_the_whole_curve(sweep: Sweep) -> None:
    for seed, run in sweep.runs.items():
        assert set(run.data.metrics) == METRICS
        assert [cycle for cycle, _ in sweep.curve(seed)] == CYCLES
        best = dict(enumerate(accumulate((length for _, length in sweep.curve(seed)), min), 1))
        told = dict(sweep.curve(seed, "best_length"))
        assert told == {cycle: best[cycle] for cycle in told}
        assert told.keys() >= {1, 200} | {cycle for cycle in CYCLES[1:] if best[cycle] < best[cycle - 1]}


def test_no_best_length_lies_below_the_exact_optimum(sweep: Sweep) -> None:
    for seed, run in sweep.runs.items():
        best = min(length for _, length in sweep.curve(seed))
        assert run.data.metrics["l1"] == best >= run.data.metrics["optimum"]


def test_params_are_the_resolved_configuration_flattened(sweep: Sweep) -> None:
    params = sweep.runs[3].data.params
    fixed = {"algo": "pdg", "map.name": "env2", "seed": "3", "iterations": "200", "diffusion.name": "gaussian"}
    assert params.items() >= fixed.items()
    assert params["post.name"] == "geometric"
    assert params["update.name"] == "dual_ant_cycle"
    assert {"diffusion.gamma", "heuristic.name", "choice.name", "alpha", "rho", "field.reach"} <= set(params)
    assert not any(key.startswith(("tracking", "report", "hydra")) for key in params)


def test_tags_hold_what_averages_are_made_by(sweep: Sweep) -> None:
    tags = [run.data.tags for run in sweep.runs.values()]
    assert len({tag["cell"] for tag in tags}) == 1
    assert len({tag["map.digest"] for tag in tags}) == 1
    assert all(tag["acoexp.version"] for tag in tags)


def test_artifacts_go_beside_the_store(home: Path, sweep: Sweep) -> None:
    experiment = sweep.client.get_experiment_by_name("acoexp")
    assert experiment.artifact_location == (home / "outputs" / "artifacts").as_uri()


def test_the_same_seeds_give_the_same_metrics_and_curves(sweep: Sweep, again: Sweep) -> None:
    for seed in range(10):
        first, second = ({**one.runs[seed].data.metrics, "seconds": 0.0} for one in (sweep, again))
        assert first == second
        assert again.curve(seed) == sweep.curve(seed)
        assert again.runs[seed].data.tags["cell"] == sweep.runs[seed].data.tags["cell"]


def test_each_job_has_a_folder_of_its_own(sweep: Sweep, again: Sweep) -> None:
    assert sweep.folder != again.folder
    for done in (sweep, again):
        assert sorted(path.parent.name for path in done.folder.glob("*/trial.json")) == sorted(map(str, range(10)))
        assert len(list(done.folder.glob("*/config.yaml"))) == 10


def test_a_jobs_record_is_what_the_store_holds(sweep: Sweep) -> None:
    for trial in trials(sweep.folder):
        run: dict[str, Any] = sweep.runs[trial["seed"]].data.metrics
        assert {key: trial[key] for key in ("x1", "x2", "x3", "l1", "l2", "optimum")}.items() <= run.items()
        assert list(enumerate(trial["curve"], 1)) == sweep.curve(trial["seed"])
        assert trial["config"] == sweep.runs[trial["seed"]].data.params


def test_a_jobs_configuration_is_the_one_that_it_ran_with(sweep: Sweep) -> None:
    configs = [yaml.safe_load(file.read_text("utf-8")) for file in sweep.folder.glob("*/config.yaml")]
    assert sorted(config["seed"] for config in configs) == list(range(10))
    assert all((c["algo"], c["map"]["name"], c["iterations"]) == ("pdg", "env2", 200) for c in configs)


def test_the_table_at_the_end_names_what_ran_and_where_it_lies(sweep: Sweep) -> None:
    assert any(line.split()[:2] == ["pdg", "env2"] for line in sweep.ended.stdout.splitlines())
    assert "10 of 10 trials finished" in sweep.ended.stdout
    assert str(sweep.folder) in sweep.ended.stdout
    assert "sqlite:///outputs/mlflow.db" in sweep.ended.stdout


def test_a_sweep_that_goes_well_is_silent_where_nobody_watches(again: Sweep) -> None:
    assert again.ended.stderr == ""
