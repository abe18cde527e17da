"""The plan of a sweep: every job is checked before anything runs; those that are kept are left out."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple, cast

from hydra.core.config_loader import ConfigLoader
from hydra.core.override_parser.types import Override
from hydra.errors import HydraException
from hydra.types import RunMode
from omegaconf import DictConfig, ListConfig, OmegaConf

from acoexp.command.handover import Handover
from acoexp.command.job import Job
from acoexp.command.options.sources import remember_options
from acoexp.command.results.contents import found_record
from acoexp.tracking.setup import Found
from acoexp.trial.seeds import check_seed

Overrides = list[str]
"""What one job is told, each ``key=value``."""


class Left(NamedTuple):
    """What is left of a sweep to run.

    Attributes:
        missing: The overrides of each job that is not in the store.
        known: Records of those that are.
        found: How many trials these are.
        trials: How many trials the sweep is of.
        repeated: How many of its jobs say what another says, and are left out: they are no further trials.
    """

    missing: list[Overrides]
    known: list[dict[str, Any]]
    found: int
    trials: int
    repeated: int


class Plan:
    """The jobs of a sweep, checked; nothing has been run or written yet.

    Args:
        config: The sweep's configuration.
        loader: Composes the configuration of a job.
        overrides: What each job is told, several values for what is swept.

    Raises:
        AcoexpError, HydraException: if a job is wrong.
    """

    def __init__(self, config: DictConfig, loader: ConfigLoader, overrides: Sequence[Override]) -> None:
        self._overrides = overrides
        self._handover = Handover()
        remember_options(loader)
        for override in overrides:
            if override.key_or_group == "seed":
                _check_seeds(override)
        of_hydra = as_written(config.hydra.overrides.hydra)
        # seeds change nothing that is checked here, so a configuration is composed once for all of them
        others = [override for override in overrides if override.key_or_group != "seed"]
        self.jobs = {
            tuple(combination): Job(
                loader.load_configuration("config", [*combination, *of_hydra], run_mode=RunMode.RUN),
                self._handover,
            )
            for combination in combinations(others)
        }
        self.trackers = {job.tracker.where: job.tracker for job in self.jobs.values()}
        self.where = ", ".join(self.trackers)
        self.has_reports = any(job.report is not None for job in self.jobs.values())

    def prepare(self, folder: Path) -> None:
        """Make the stores ready, and hand over to the workers what they need of this machine.

        Args:
            folder: The sweep's folder.
        """
        for tracker in self.trackers.values():
            tracker.prepare()
        for job in self.jobs.values():
            if job.tracker.address is not None:
                self._handover.addresses[job.config["tracking"]["uri"]] = job.tracker.address
        self._handover.put_maps(folder, [(job.config["map"], job.setup.grid) for job in self.jobs.values()])

    def leave_out_known(self) -> Left:
        """Return what is not in the store yet, and the records of what is."""
        left, seen = Left([], [], 0, 0, 0), set[str]()
        in_store = self._in_store()
        for overrides in combinations(self._overrides):
            job = self.jobs[tuple(text for text in overrides if not _is_seed(text))]
            seed = next((text.partition("=")[2] for text in overrides if _is_seed(text)), str(job.keys.seed))
            identity = job.setup.identity(seed if job.seeds is None else job.seeds)
            if job.report is None and identity in seen:
                left = left._replace(repeated=left.repeated + 1)
                continue
            seen.add(identity)
            run = None if job.report else in_store.get(job.setup.configuration_id, {}).get(identity)
            left = left._replace(trials=left.trials + job.trials)
            if run is None:
                left.missing.append(overrides)
            else:
                left.known.append(found_record(job.setup, run))
                left = left._replace(found=left.found + job.trials)
        return left

    def _in_store(self) -> Mapping[str, Mapping[str, Found]]:
        """Return the finished runs of each configuration by identity, where kept trials count."""
        return {
            job.setup.configuration_id: job.tracker.find(job.setup.configuration_id)
            for job in self.jobs.values()
            if job.keys.resume
        }


def as_written(overrides: ListConfig) -> list[str]:
    """Return overrides with what they refer to, such as ``${hydra.job.num}``, which only a job knows."""
    return cast(list[str], OmegaConf.to_container(overrides, resolve=False))


def combinations(overrides: Iterable[Override]) -> list[Overrides]:
    """Return what each job of a sweep is told: one of the values of each key, the last key's changing fastest.

    Raises:
        HydraException: for a sweep that only an optimiser can choose from, such as ``interval(0, 1)``.
    """
    values: dict[str, list[str]] = {}
    for override in overrides:
        key = override.get_key_element()
        values[key] = [f"{key}={value}" for value in _values(override)]
    return [list(combination) for combination in product(*values.values())]


def first_number(folder: Path) -> int:
    """Return the number of a sweep's first job: one that no job in its folder, of an earlier sweep, has."""
    numbers = [int(job.name) for job in folder.iterdir() if job.is_dir() and job.name.isdecimal()]
    return max(numbers, default=-1) + 1


def fix_folder(config: DictConfig) -> Path:
    """Name a sweep's folder absolutely, for jobs that are composed elsewhere too; return it."""
    folder = Path(config.hydra.sweep.dir).absolute()
    config.hydra.sweep.dir = str(folder)
    quoted = str(folder).replace("'", r"\'")
    config.hydra.overrides.hydra.append(f"hydra.sweep.dir='{quoted}'")
    return folder


def _values(override: Override) -> list[str]:
    if not override.is_sweep_override():
        return [override.get_value_element_as_str()]
    if override.is_discrete_sweep():
        return list(override.sweep_string_iterator())
    raise HydraException(
        f"{override.input_line}: expected values or a range, such as 0.1,0.2 or range(0,9); only another "
        "hydra/sweeper, such as optuna, chooses from an interval"
    )


def _is_seed(text: str) -> bool:
    return text.lstrip("+").partition("=")[0] == "seed"


def _check_seeds(override: Override) -> None:
    for text in _values(override):
        check_seed(int(text) if re.fullmatch("0|[1-9][0-9]*", text) else text)
