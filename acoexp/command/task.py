"""What Hydra runs of each job: its configuration is checked, then the job is run."""

from __future__ import annotations

import pickle
from functools import lru_cache
from pathlib import Path
from typing import Any

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf

from acoexp.command.handover import Handover
from acoexp.command.job import Job
from acoexp.command.options.keys import JobKeys
from acoexp.console.ending import FAILED, print_error, said_of
from acoexp.errors import AcoexpError, StoreGoneError


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


def plain(config: DictConfig) -> dict[str, Any]:
    """Return what a configuration says, but for Hydra's own part: resolved, as plain values."""
    if "hydra" in config:
        config = OmegaConf.masked_copy(config, [str(key) for key in config if key != "hydra"])
    values = OmegaConf.to_container(config, resolve=True)
    return {str(key): value for key, value in values.items()} if isinstance(values, dict) else {}


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
