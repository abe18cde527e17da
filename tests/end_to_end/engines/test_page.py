"""Every command of docs/engines.md runs as it stands there, on real servers; only addresses are other ones."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
import servers
from mlflow import MlflowClient
from running import environment, trials

import acoexp

pytestmark = [pytest.mark.slow_without_jit, pytest.mark.usefixtures("joblib")]

PAGE = Path(__file__).parents[3] / "docs" / "engines.md"
BLOCKS = re.findall(r"^```bash\n(.*?)\n```$", PAGE.read_text(encoding="utf-8"), re.M | re.S)
DATABASE, SERVER = "postgresql://acoexp@db.example.org/acoexp", "http://127.0.0.1:5000"


def block(word: str) -> str:
    """Return the page's one command that has a word."""
    (found,) = (text for text in BLOCKS if word in text)
    return str(found)


def run(command: str, home: Path, env: Mapping[str, str]) -> str:
    """Run a command as a reader would; return what it prints."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", command],
        cwd=home,
        env=environment({**env, "PATH": path}),
        capture_output=True,
        text=True,
        timeout=240.0,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("engine", ["slurm", "ray", "joblib"])
def test_a_sweep_on_an_engine_finds_what_a_trial_in_this_process_finds(
    engine: str, request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    command = block(f"engine={engine} ") if engine != "joblib" else block("engine=joblib algo")
    shown = run(command, tmp_path, request.getfixturevalue(engine))
    assert re.search(r"(\d+) of \1 trials finished", shown)
    client = MlflowClient(f"sqlite:///{tmp_path}/outputs/mlflow.db")
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    stored = {(r.data.params["algo"], int(r.data.params["seed"])): r.data.metrics for r in runs}
    found = trials(tmp_path)
    assert len(found) == len(runs) == len(stored) >= 2
    for trial in found:
        here = json.loads(json.dumps(acoexp.solve("env2", algo=trial["algo"], seed=trial["seed"]).as_dict()))
        assert {key: trial[key] for key in here} == here
        metrics = {name: here[name] for name in ("x1", "x3", "l1", "l2")}
        assert stored[trial["algo"], trial["seed"]].items() >= metrics.items()


def test_a_study(tmp_path: Path) -> None:
    pytest.importorskip("optuna")
    assert "240 of 240 trials finished" in run(block("n_trials=12"), tmp_path, {})
    for before in ("", "study rho goes on after 20 trials"):
        assert before in run(f"{block('study_name=rho')} 2>&1", tmp_path, {})


def test_a_database_then_a_server_on_it(fresh_database: Callable[[str], str], tmp_path: Path) -> None:
    uri = fresh_database("page")
    run(block(f"tracking.uri={DATABASE}").replace(DATABASE, uri), tmp_path, {})
    served = f"http://127.0.0.1:{servers.free_port()}"
    command = block("mlflow server").replace(DATABASE, uri).split()
    command += ["--port", served.rpartition(":")[2], "--workers", "1"]
    with servers.running(
        [sys.executable, "-m", *command], tmp_path, {"MLFLOW_SERVER_ENABLE_JOB_EXECUTION": "false"}
    ):
        servers.until(lambda: servers.answers(served))
        run(block(f"tracking.uri={SERVER}").replace(SERVER, served), tmp_path, {})
    client = MlflowClient(uri)
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    assert sorted(int(run.data.params["seed"]) for run in runs) == list(range(8))
