"""The command as a person runs it: in a process of its own, in a folder of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from forked import run_forked

QUICK = ("tracking=none", "iterations=3", "ants=2")
"""For tests that do not look at numbers: no store, and few steps where kernels are not compiled."""

_MEANT_FOR_OTHERS = ("COLUMNS", "HYDRA_FULL_ERROR", "MLFLOW_TRACKING_URI", "PYTHONIOENCODING")


def run_acoexp(
    *args: str,
    cwd: Path,
    env: Mapping[str, str] | None = None,
    python: Sequence[str] = (),
    timeout: float = 120.0,
) -> subprocess.CompletedProcess[str]:
    """Run ``python -m acoexp`` to its end: in a fresh Python if an environment or options are given, else forked.

    Args:
        args: Its arguments.
        cwd: Its working directory.
        env: What to set in its environment.
        python: Options of Python itself.
        timeout: Seconds after which it is killed and the test fails.
    """
    if env is None and not python:
        return run_forked(args, cwd, environment(), timeout)
    return subprocess.run(
        [sys.executable, *python, "-m", "acoexp", *args],
        cwd=cwd,
        env=environment(env),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=timeout,
        check=False,
    )


def environment(changes: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return the environment for a process: ours, without what would change its output."""
    return {k: v for k, v in os.environ.items() if k not in _MEANT_FOR_OTHERS} | dict(changes or {})


def refusal(*args: str, cwd: Path, **options: Any) -> str:
    """Run something that must be refused, check how it is, and return the message.

    Status 1, one line to the person, nothing else, and not a file written.
    """
    before = listing(cwd)
    ended = run_acoexp(*args, cwd=cwd, **options)
    assert ended.returncode == 1, ended.stdout + ended.stderr
    assert ended.stderr.startswith("acoexp: error: "), ended.stderr
    assert ended.stderr.count("\n") == 1, ended.stderr
    assert listing(cwd) == before
    return ended.stderr.removeprefix("acoexp: error: ").rstrip("\n")


def install(site: Path, name: str, entries: str, files: Mapping[str, str]) -> dict[str, str]:
    """Install a package of version 1.0 as pip would leave it, and return the environment in which it is found.

    Args:
        site: The folder that packages lie in.
        name: The distribution's name, ``-`` for ``_``.
        entries: Its entry points.
        files: Its files by name, which begins with the name of its module.
    """
    metadata = f"{name.replace('-', '_')}-1.0.dist-info"
    described = {
        f"{metadata}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n",
        f"{metadata}/entry_points.txt": entries,
    }
    for file, text in {**described, **files}.items():
        (site / file).parent.mkdir(parents=True, exist_ok=True)
        (site / file).write_text(text, encoding="utf-8")
    return {"PYTHONPATH": os.pathsep.join([str(site), *filter(None, [os.environ.get("PYTHONPATH")])])}


def listing(folder: Path) -> set[str]:
    """Return the names of everything below a folder."""
    return {str(path.relative_to(folder)) for path in folder.rglob("*")}


def records(folder: Path) -> list[Path]:
    """Return the records of all finished trials below a folder, in the order of their names."""
    return sorted(folder.rglob("trial.json"))


def trials(folder: Path) -> list[dict[str, Any]]:
    """Return what all finished trials below a folder found."""
    return [json.loads(file.read_text(encoding="utf-8")) for file in records(folder)]
