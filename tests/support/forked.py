"""Commands in processes forked from one that has imported everything: separate as any, without seconds of imports.

What depends on how Python starts (its options, its environment, a cold start) needs a real process instead.
"""

from __future__ import annotations

import atexit
import multiprocessing
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from functools import cache
from multiprocessing import forkserver
from multiprocessing.context import ForkServerContext
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Lock
from unittest.mock import patch

STARTING = Lock()


def run_forked(
    args: Sequence[str], cwd: Path, env: Mapping[str, str], timeout: float
) -> subprocess.CompletedProcess[str]:
    """Run ``python -m acoexp`` to its end.

    Args:
        args: Its arguments.
        cwd: Its working directory.
        env: Its whole environment.
        timeout: Seconds after which it is killed.

    Raises:
        subprocess.TimeoutExpired: if it was killed.
    """
    with TemporaryDirectory() as folder:
        out, err = Path(folder, "out"), Path(folder, "err")
        process = forking().Process(target=_main, args=(list(args), str(cwd), dict(env), str(out), str(err)))
        process.start()
        process.join(timeout)
        if process.is_alive():
            process.kill()
            process.join()
            raise subprocess.TimeoutExpired(list(args), timeout)
        code = process.exitcode
        assert code is not None
        return subprocess.CompletedProcess(list(args), code, out.read_text("utf-8"), err.read_text("utf-8"))


def forking() -> ForkServerContext:
    """Return what forks processes that have imported everything."""
    with STARTING:
        return _started()


@cache
def _started() -> ForkServerContext:
    """Start the process that is forked, where it finds what is beside this file."""
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["preloaded"])
    path = [str(Path(__file__).parent), *filter(None, [os.environ.get("PYTHONPATH")])]
    with patch.dict(os.environ, PYTHONPATH=os.pathsep.join(path)):
        forkserver.ensure_running()
    return context


def _main(args: list[str], cwd: str, env: dict[str, str], out: str, err: str) -> None:
    """Become the command: its folder, its environment, its output; then run it, and what is to run at its exit."""
    os.chdir(cwd)
    os.environ.clear()
    os.environ.update(env)
    for stream, name in ((1, out), (2, err)):
        os.dup2(os.open(name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), stream)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    sys.argv = ["acoexp", *args]
    from acoexp.command.main import main

    try:
        main()
    finally:
        atexit._run_exitfuncs()
        sys.stdout.flush()
        sys.stderr.flush()
