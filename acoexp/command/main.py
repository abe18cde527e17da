"""The command's entry: arguments in order, options registered; then Hydra takes over and calls for each job."""

from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext, redirect_stdout
from functools import lru_cache
from io import StringIO
from pathlib import Path

import hydra
from hydra.core.hydra_config import HydraConfig
from hydra.errors import HydraException
from hydra.types import RunMode
from omegaconf import DictConfig
from omegaconf.errors import OmegaConfBaseException

from acoexp.command.handover import Handover
from acoexp.command.job import Job, plain
from acoexp.command.messages import in_one_line
from acoexp.command.options.arguments import normalise
from acoexp.command.options.flags import PARTS_INFO, complete_past_flags
from acoexp.command.options.keys import JobKeys
from acoexp.command.options.listing import parts_text
from acoexp.command.options.registering import register_options
from acoexp.console.ending import FAILED, ends_cleanly, print_error, said_of
from acoexp.errors import AcoexpError, StoreGoneError
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
    register_options(arguments.config_dir, with_help=arguments.help)
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


def run_job(config: DictConfig) -> float:
    """Run what a configuration describes; see :meth:`acoexp.command.job.Job.run`.

    Raises:
        AcoexpError, OSError: for whatever went wrong with a job of a sweep; a single one ends the program, as
            Hydra would print a line of its own.
    """
    handover = Handover()
    with handover.in_parent_folder():  # files and stores are named from there, also under hydra.job.chdir
        run = handover.ready or _job_of(config, handover).run
        try:
            return run()
        except (AcoexpError, OSError) as problem:
            alone = HydraConfig.get().mode == RunMode.RUN
            if not (alone or isinstance(problem, StoreGoneError)):  # no further job could be kept then either
                raise
            print_error(said_of(problem))
            raise SystemExit(FAILED) from problem


def _job_of(config: DictConfig, handover: Handover) -> Job:
    """Return the checked job; of a sweep's trials that differ by their seed alone, one is checked."""
    values = plain(config)
    if handover.folder is None or values.get("report") != {"name": "none"}:
        return Job(values, handover)
    others = {key: value for key, value in values.items() if key != "seed"}
    return _checked(pickle.dumps(others), handover.folder, handover).with_seed(values.get("seed"))


@lru_cache(maxsize=1)
def _checked(others: bytes, sweep: Path, handover: Handover) -> Job:
    """Return a job of a sweep, given all but its seed; the sweep's maps are what they are."""
    return Job({"seed": JobKeys().seed, **pickle.loads(others)}, handover)
