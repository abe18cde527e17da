"""``seeds=0-9`` as a person runs it: one run, a table, and a second time nothing to do."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest
from mlflow import MlflowClient
from mlflow.entities import Run
from running import QUICK, refusal, run_acoexp

from acoexp import solve_many

SMALL = ("iterations=3", "ants=2")


def runs_in(home: Path) -> list[Run]:
    """Return all runs in the store."""
    client = MlflowClient(f"sqlite:///{home}/outputs/mlflow.db")
    return list(client.search_runs([client.get_experiment_by_name("acoexp").experiment_id]))


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder in which a sweep of two batches was run."""
    home = tmp_path_factory.mktemp("batches")
    ended = run_acoexp("algo=aco,pd", "-m", "seeds=0-9,20", *SMALL, cwd=home)
    assert ended.returncode == 0, ended.stderr
    assert "22 of 22 trials finished" in ended.stdout
    return home


def test_each_batch_is_one_run(home: Path) -> None:
    runs = {run.data.params["algo"]: run for run in runs_in(home)}
    assert runs.keys() == {"aco", "pd"}
    for algo, run in runs.items():
        results = solve_many("fig13", algo, [*range(10), 20], iterations=3, ants=2)
        assert run.data.metrics["trials"] == 11
        assert run.data.metrics["lost_ants"] == sum(int(r.lost_ants.sum()) for r in results) / 11
        assert run.data.params["seeds"] == "0-9,20"
        assert not {"seed", "threads", "resume"} & set(run.data.params)


def test_each_job_leaves_a_record_and_a_table(home: Path) -> None:
    records = [json.loads(file.read_text("utf-8")) for file in home.rglob("batch.json")]
    assert sorted(record["algo"] for record in records) == ["aco", "pd"]
    for file in home.glob("outputs/sweeps/*/*/*/trials.csv"):
        rows = list(csv.DictReader(file.read_text("utf-8").splitlines()))
        assert [int(row["seed"]) for row in rows] == [*range(10), 20]


def test_again_all_is_found_and_the_table_is_the_same(home: Path) -> None:
    before = [run.info.run_id for run in runs_in(home)]
    ended = run_acoexp("algo=aco,pd", "-m", "seeds=0-9,20", *SMALL, cwd=home)
    assert "acoexp: 22 of 22 trials found in the store" in ended.stderr
    assert "0 of 22 trials finished" in ended.stdout
    assert [line.split()[:2] for line in ended.stdout.splitlines()[1:2]] == [["aco", "fig13"]]
    assert [run.info.run_id for run in runs_in(home)] == before


def test_a_single_batch_needs_no_m(home: Path) -> None:
    ended = run_acoexp("algo=aco", "seeds=5-24", "threads=1", *SMALL, cwd=home)
    assert ended.returncode == 0, ended.stderr
    assert "acoexp: aco on fig13: 6 of 20 trials found in the store" in ended.stderr
    assert "14 of 20 trials finished" in ended.stdout
    assert ", 6 found in the store" in ended.stdout


def test_a_sweep_of_trials_takes_what_is_there(home: Path) -> None:
    for seeds, said in (("0-2", None), ("0-4", "acoexp: 3 of 5 trials found in the store")):
        ended = run_acoexp("algo=pf", "-m", f"seed={seeds}", *SMALL, cwd=home)
        assert ended.returncode == 0, ended.stderr
        assert said is None or said in ended.stderr
    assert "2 of 5 trials finished" in ended.stdout
    seeds_of = [run.data.params.get("seed") for run in runs_in(home) if run.data.params["algo"] == "pf"]
    assert sorted(map(str, seeds_of)) == ["0", "1", "2", "3", "4"]


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("threads=0", "threads: expected a whole number from 1 to 4096; got 0"),
        ("threads=two", "threads: expected a whole number"),
        ("resume=perhaps", "resume: expected true or false; got 'perhaps'"),
        ("seeds=9-0", "seeds: expected a range from low to high"),
    ],
)
def test_what_makes_no_batch_is_refused(override: str, said: str, tmp_path: Path) -> None:
    given = [] if override.startswith("seeds") else ["seeds=0-3"]
    assert refusal(*given, override, *QUICK, cwd=tmp_path).startswith(said)
