"""Real servers for tests and benchmarks: on loopback, in a folder and on ports of their own, gone afterwards."""

from __future__ import annotations

import os
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from running import environment

SBIN = "/usr/sbin:/sbin"
PATIENCE = 60.0


class NoServerError(Exception):
    """A program that is not installed."""


@contextmanager
def slurm() -> Iterator[dict[str, str]]:
    """Run a Slurm cluster of one node with as many cores as there are; yield the environment to use it in."""
    munged, slurmctld, slurmd = map(program, ("munged", "slurmctld", "slurmd"))
    with ExitStack() as stack:
        home = stack.enter_context(scratch())
        (home / "slurm.conf").write_text(_slurm_conf(home), encoding="utf-8")
        key = home / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        files = {
            "key-file": key.name,
            "socket": "munge.socket",
            "pid-file": "munged.pid",
            "seed-file": "munged.seed",
        }
        options = [f"--{option}={home / file}" for option, file in files.items()]
        env = {"SLURM_CONF": str(home / "slurm.conf")}
        stack.enter_context(running([munged, "--foreground", "--force", *options], home))
        until((home / "munge.socket").exists)
        stack.enter_context(running([slurmctld, "-D"], home, env))
        stack.enter_context(running([slurmd, "-D", "-N", "localhost"], home, env))
        until(lambda: says(["sinfo", "--noheader", "--format=%t"], env) == "idle")
        try:
            yield env
        finally:
            says(["scancel", "--user", pwd.getpwuid(os.getuid()).pw_name], env)


def _slurm_conf(home: Path) -> str:
    user = pwd.getpwuid(os.getuid()).pw_name
    settings = {
        "ClusterName": "acoexp",
        "SlurmctldHost": "localhost(127.0.0.1)",
        "SlurmctldPort": free_port(),
        "CommunicationParameters": "NoCtldInAddrAny,NoInAddrAny",
        "SlurmUser": user,
        "SlurmdUser": user,
        "AuthType": "auth/munge",
        "AuthInfo": f"socket={home}/munge.socket",
        "StateSaveLocation": home / "state",
        "SlurmdSpoolDir": home / "spool",
        "SlurmctldPidFile": home / "slurmctld.pid",
        "SlurmdPidFile": home / "slurmd.pid",
        "ProctrackType": "proctrack/linuxproc",
        "TaskPlugin": "task/none",
        "JobAcctGatherType": "jobacct_gather/none",
        "MpiDefault": "none",
        "ReturnToService": 2,
        "SchedulerParameters": "batch_sched_delay=0,sched_min_interval=0",
        "SelectType": "select/cons_tres",
        "SelectTypeParameters": "CR_CPU",
    }
    (home / "state").mkdir()
    (home / "spool").mkdir()
    node = f"NodeName=localhost NodeAddr=127.0.0.1 Port={free_port()} CPUs={os.cpu_count()} State=UNKNOWN"
    partition = "PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP"
    return "\n".join([*(f"{key}={value}" for key, value in settings.items()), node, partition, ""])


@contextmanager
def ray() -> Iterator[dict[str, str]]:
    """Run a Ray cluster of one node, whose workers start in its folder; yield the environment to use it in."""
    executable = program("ray")
    with scratch() as home:
        address = f"127.0.0.1:{free_port()}"
        # what it calls clusters of Windows is one on loopback: else it looks for an address that others can reach
        env = {
            "RAY_ENABLE_WINDOWS_OR_OSX_CLUSTER": "0",
            "RAY_AUTH_MODE": "disabled",
            "RAY_USAGE_STATS_ENABLED": "0",
        }
        command = [executable, "start", "--head", "--block", f"--port={address.rpartition(':')[2]}"]
        command += ["--include-dashboard=false", f"--temp-dir={home}"]
        command += [
            f"--{port}={free_port()}" for port in ("ray-client-server-port", "dashboard-agent-listen-port")
        ]
        with running(command, home, env):
            until(lambda: "CPU" in says([executable, "status", f"--address={address}"], env))
            yield {**env, "RAY_ADDRESS": address}


@contextmanager
def postgresql() -> Iterator[Callable[[str], str]]:
    """Run a PostgreSQL server; yield what makes a fresh database of a name and returns its address."""
    initdb, postgres, createdb, ready = map(program, ("initdb", "postgres", "createdb", "pg_isready"))
    user = "postgres" if os.getuid() == 0 else None  # it refuses to run as root
    with scratch() as home:
        if user:
            shutil.chown(home, user)
        port = str(free_port())
        command = [initdb, "--username=acoexp", "--auth=trust", "--no-sync", f"--pgdata={home}/data"]
        subprocess.run(command, cwd=home, user=user, check=True, capture_output=True, timeout=PATIENCE)
        where = ["-h", "127.0.0.1", "-p", port]
        with running([postgres, "-D", f"{home}/data", "-k", str(home), "-F", *where], home, user=user):
            until(lambda: "accepting" in says([ready, *where]))

            def fresh(name: str) -> str:
                subprocess.run([createdb, *where, "-U", "acoexp", name], check=True, timeout=PATIENCE)
                return f"postgresql://acoexp@127.0.0.1:{port}/{name}"

            yield fresh


def program(name: str) -> str:
    """Return where a program is.

    Raises:
        NoServerError: if it is not installed.
    """
    ours = str(Path(sys.executable).parent)
    debian = sorted(map(str, Path("/usr/lib/postgresql").glob("*/bin")), reverse=True)
    found = shutil.which(name, path=os.pathsep.join([ours, *debian, os.environ["PATH"], *SBIN.split(":")]))
    if found is None:
        raise NoServerError(f"{name} is not installed")
    return found


@contextmanager
def scratch() -> Iterator[Path]:
    """Make a folder whose name is short enough for sockets; remove it in the end."""
    home = Path(tempfile.mkdtemp(prefix="acoexp-"))
    try:
        yield home
    finally:
        shutil.rmtree(home, ignore_errors=True)


@contextmanager
def running(
    command: list[str], home: Path, env: Mapping[str, str] | None = None, user: str | None = None
) -> Iterator[None]:
    """Run a server as long as this lasts, with all that it starts; what it says is in a file beside it."""
    log = home / f"{Path(command[0]).name}.log"
    with log.open("wb") as out:
        process = subprocess.Popen(
            command,
            cwd=home,
            env=environment(env),
            user=user,
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
    try:
        yield
    except TimeoutError as problem:
        raise AssertionError(log.read_text("utf-8", errors="replace")[-4000:]) from problem
    finally:
        process.send_signal(signal.SIGINT)
        with suppress(subprocess.TimeoutExpired):
            process.wait(timeout=20.0)
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait(timeout=20.0)


def says(command: list[str], env: Mapping[str, str] | None = None) -> str:
    """Return what a command prints, well or not."""
    done = subprocess.run(
        command, env=environment(env), capture_output=True, text=True, timeout=PATIENCE, check=False
    )
    return done.stdout.strip()


def answers(uri: str) -> bool:
    """Tell whether an MLflow server is up."""
    try:
        with urllib.request.urlopen(f"{uri}/health", timeout=5.0) as response:
            return bool(response.status == 200)
    except OSError:
        return False


def until(there: Callable[[], bool]) -> None:
    """Wait for something to come up."""
    deadline = time.monotonic() + PATIENCE
    while not there():
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(0.1)


def free_port() -> int:
    """Return a port that nobody listens on."""
    with socket.socket() as sock:
        sock.bind(("127.0.0.1", 0))
        return int(sock.getsockname()[1])
