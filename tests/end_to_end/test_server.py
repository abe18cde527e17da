"""A real MLflow server as the store, and one that is not there."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest
from mlflow import MlflowClient
from running import environment, listing, refusal, run_acoexp, trials

pytestmark = pytest.mark.skipif(os.name != "posix", reason="stops the server's process group")


def free_port() -> int:
    """Return a port that nobody listens on."""
    with socket.socket() as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])


def answers(uri: str) -> bool:
    """Tell whether a server is up."""
    try:
        with urllib.request.urlopen(f"{uri}/health", timeout=5.0) as response:
            return bool(response.status == 200)
    except (urllib.error.URLError, OSError):
        return False


@contextmanager
def serving(home: Path, uri: str) -> Iterator[subprocess.Popen[bytes]]:
    """Run an MLflow server whose store lies in a folder; it is killed in the end."""
    options = ["--backend-store-uri", f"sqlite:///{home}/served.db", "--artifacts-destination", f"{home}/served"]
    command = ["mlflow", "server", *options, "--port", uri.rpartition(":")[2], "--workers", "1"]
    with (home / "log").open("w") as log:
        process = subprocess.Popen(
            [sys.executable, "-m", *command],
            cwd=home,
            env=environment({"MLFLOW_SERVER_ENABLE_JOB_EXECUTION": "false"}),  # no helpers that outlive it
            stdout=log,
            stderr=subprocess.STDOUT,
            start_new_session=True,  # it has children, which end with it
        )
    try:
        deadline = time.monotonic() + 90.0
        while not answers(uri):
            assert process.poll() is None, (home / "log").read_text()
            assert time.monotonic() < deadline
            time.sleep(0.1)
        yield process
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # at once: nobody needs its store any more
        process.wait(timeout=30.0)


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a server's store."""
    return tmp_path_factory.mktemp("server")


@pytest.fixture
def server(home: Path) -> Iterator[str]:
    """Run an MLflow server and return its address."""
    uri = f"http://127.0.0.1:{free_port()}"
    with serving(home, uri):
        yield uri


def test_a_server_takes_the_runs_of_a_sweep_and_what_is_too_long(server: str, tmp_path: Path) -> None:
    folder = Path(*(["a" * 200] * 3))
    (tmp_path / folder).mkdir(parents=True)
    (tmp_path / folder / "yard.txt").write_text("S..\n...\n..G\n", encoding="utf-8")
    ended = run_acoexp(
        "map=file",
        f"map.path={folder}/yard.txt",
        "-m",
        "seed=0,1",
        f"tracking.uri={server}",
        "iterations=3",
        cwd=tmp_path,
    )
    assert ended.returncode == 0, ended.stderr
    client = MlflowClient(server)
    runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    assert {run.data.params["seed"] for run in runs} == {"0", "1"}
    assert {run.info.status for run in runs} == {"FINISHED"}
    assert {run.data.metrics["l1"] for run in runs} == {trial["l1"] for trial in trials(tmp_path)}
    for run in runs:
        file = client.download_artifacts(run.info.run_id, "params/map.path.txt", str(tmp_path))
        assert Path(file).read_text(encoding="utf-8") == f"{folder}/yard.txt"
    assert not list(tmp_path.rglob("*.db"))


def test_a_password_in_the_address_of_a_server_is_printed_and_written_nowhere(
    server: str, home: Path, tmp_path: Path
) -> None:
    uri = server.replace("://", "://me:p4ss-w0rd@")
    quick = ("algo=aco", f"tracking.uri={uri}", "iterations=3", "ants=2")
    for command in (("seed=0",), ("-m", "seed=0-1"), ("-m", "seeds=0-1"), ("iterations=-1",), ("nokey=1",)):
        ended = run_acoexp(*quick, *command, cwd=tmp_path)
        assert "p4ss-w0rd" not in ended.stdout + ended.stderr
    assert [file for file in tmp_path.rglob("*") if file.is_file() and b"p4ss-w0rd" in file.read_bytes()] == []
    assert [file for file in home.rglob("*.db*") if b"p4ss-w0rd" in file.read_bytes()] == []
    assert len(list(tmp_path.rglob("multirun.yaml"))) == 2  # it was looked for where it would be
    assert "uri: http://***@127.0.0.1" in next(tmp_path.rglob(".hydra/config.yaml")).read_text("utf-8")


def test_a_server_that_is_not_there_is_told_soon_and_in_one_line(tmp_path: Path) -> None:
    uri = f"http://127.0.0.1:{free_port()}"
    message = refusal(f"tracking.uri={uri}", "iterations=3", "-m", cwd=tmp_path, timeout=30.0)
    assert message.startswith(
        f"tracking.uri: expected an MLflow store that can be written; {uri} cannot be opened"
    )


def test_a_trial_alone_is_shown_and_has_its_files_where_the_server_is_not_there(tmp_path: Path) -> None:
    uri = f"http://127.0.0.1:{free_port()}"
    ended = run_acoexp(f"tracking.uri={uri}", "algo=aco", "hydra.run.dir=here", cwd=tmp_path)
    assert ended.returncode == 1
    assert ended.stderr.startswith(
        f"acoexp: error: tracking.uri: expected an MLflow store that can be written; {uri}"
    )
    assert ended.stderr.count("\n") == 1
    assert ended.stdout.splitlines()[-2:] == ["files: here", "pictures follow, then where it is kept"]
    assert {"trial.json", "path.csv", "path.png", "convergence.png"} <= listing(tmp_path / "here")


def test_a_server_that_is_killed_and_comes_back_within_a_sweep_loses_nothing(tmp_path: Path) -> None:
    store, work = tmp_path / "store", tmp_path / "work"
    store.mkdir()
    work.mkdir()
    uri = f"http://127.0.0.1:{free_port()}"
    sweep_of_twenty = ("-m", "algo=aco", "seed=0-19", "iterations=5", "ants=2", f"tracking.uri={uri}")
    with serving(store, uri):
        sweep = subprocess.Popen(
            [sys.executable, "-m", "acoexp", *sweep_of_twenty],
            cwd=work,
            env=environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        deadline = time.monotonic() + 120.0
        while len(trials(work)) < 5:
            assert sweep.poll() is None, sweep.communicate()[1]
            assert time.monotonic() < deadline
            time.sleep(0.05)
    time.sleep(2.0)  # it is away while trials end
    with serving(store, uri):
        said = sweep.communicate(timeout=240.0)
        assert sweep.returncode == 0, said
        assert "20 of 20 trials finished" in said[0]
        assert "trying again" in said[1]
        client = MlflowClient(uri)
        runs = client.search_runs([client.get_experiment_by_name("acoexp").experiment_id])
    assert {run.info.status for run in runs} == {"FINISHED"}
    assert sorted(int(run.data.params["seed"]) for run in runs) == list(range(20))
