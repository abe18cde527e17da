"""The command's entry: arguments are put in order, options registered, then Hydra takes over."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, redirect_stdout
from io import StringIO

import hydra
from hydra.errors import HydraException
from omegaconf.errors import OmegaConfBaseException

from acoexp.command.messages import in_one_line
from acoexp.command.options.arguments import normalise
from acoexp.command.options.flags import PARTS_INFO, complete_past_flags
from acoexp.command.options.listing import parts_text
from acoexp.command.options.registering import register_options
from acoexp.command.task import run_job
from acoexp.console.ending import ends_cleanly
from acoexp.errors import AcoexpError
from acoexp.registry.folders import conf_dir
from acoexp.tracking.mlflow.masking import masked

_ENGINES = ("submitit", "ray", "joblib")
"""Packages whose own errors say that a job was lost with its worker."""


def main() -> None:
    """Run ``acoexp`` with the arguments of this process; leaves by ``SystemExit`` if anything is wrong."""
    wants_traceback = os.environ.get("HYDRA_FULL_ERROR") == "1"
    os.environ["HYDRA_FULL_ERROR"] = "1"  # so that Hydra hands its errors to us instead of printing them
    with ends_cleanly("what was finished is kept", lambda p: None if wants_traceback else _describe(p)):
        try:
            _run()
        except SystemExit as ended:  # a job has said what is wrong
            if wants_traceback and ended.__cause__ is not None:
                raise ended.__cause__ from None
            raise


def _run() -> None:
    arguments = normalise(sys.argv[1:])
    if arguments.info == PARTS_INFO:
        print(parts_text())
        return
    register_options(arguments.config_dir)
    sys.argv[1:] = arguments.argv
    complete_past_flags(os.environ)
    run = hydra.main(version_base="1.3", config_path=str(conf_dir()), config_name="config")(run_job)
    with _masked_output() if arguments.info or arguments.cfg else nullcontext():
        run()


@contextmanager
def _masked_output() -> Iterator[None]:
    """Print what Hydra shows of a configuration without the passwords in it."""
    shown = StringIO()
    try:
        with redirect_stdout(shown):
            yield
    finally:
        sys.stdout.write(masked(shown.getvalue()))


def _describe(problem: Exception) -> str | None:
    ours = isinstance(problem, AcoexpError | HydraException | OmegaConfBaseException | OSError)
    engines = type(problem).__module__.partition(".")[0] in _ENGINES
    return in_one_line(problem) if ours or engines else None
