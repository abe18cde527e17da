"""The plan of a sweep: every job is checked before anything runs; those that are kept are left out."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from fcntl import LOCK_EX, LOCK_NB, flock
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
from acoexp.command.options.quoting import hydra_text, literal
from acoexp.command.options.sources import remember_options
from acoexp.command.results.contents import found_record
from acoexp.errors import SettingsError, shown
from acoexp.tracking.setup import Found
from acoexp.tracking.tracker import Tracker
from acoexp.trial.seeds import Seeds, check_seed

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
        told: What a few jobs are told, where an optimiser will choose the others; else each combination is one.

    Raises:
        AcoexpError, HydraException: if a job is wrong.
    """

    def __init__(
        self,
        config: DictConfig,
        loader: ConfigLoader,
        overrides: Sequence[Override],
        told: Iterable[Overrides] | None = None,
    ) -> None:
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
            tuple(combination): Job(_composed(loader, [*combination, *of_hydra]), self._handover)
            for combination in (combinations(others) if told is None else told)
        }
        self.trackers = {job.tracker.where: job.tracker for job in self.jobs.values()}
        self.where = ", ".join(self.trackers)
        self.has_reports = any(job.report is not None for job in self.jobs.values())
        if self.has_reports and told is None:
            self._check_report_folders()

    def is_kept(self) -> bool:
        """Tell whether a quick look shows that every trial is in its store, which then need not be made ready."""
        if not all(job.keys.resume and job.report is None for job in self.jobs.values()):
            return False
        return all(tracker.has_all(wanted) for (tracker, _), wanted in self._wanted().items())

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
        left, seen = Left([], [], 0, 0, 0), set[tuple[str | None, str, str]]()
        in_store = self._in_store()
        for overrides, job, seeds in self._each():
            identity = job.tracker.address, job.tracker.where, job.setup.identity(seeds)
            if job.report is None and identity in seen:
                left = left._replace(repeated=left.repeated + 1)
                continue
            seen.add(identity)
            run = None if job.report else in_store.get(identity)
            left = left._replace(trials=left.trials + job.trials)
            if run is None:
                left.missing.append(overrides)
            else:
                left.known.append(found_record(job.setup, seeds, run))
                left = left._replace(found=left.found + job.trials)
        return left

    def _check_report_folders(self) -> None:
        """Refuse a folder that several jobs would write their reports to.

        Raises:
            SettingsError: if there is one.
        """
        seen = set[str]()
        for _, job, _ in self._each():
            folder = None if job.report is None else job.report.folder
            if folder is None:
                continue
            if os.path.realpath(folder) in seen:
                raise SettingsError(
                    "report.folder: expected one for each job of a sweep, such as 'report.folder=\"out/${rho}\"'; "
                    f"got {shown(str(folder))} for several"
                )
            seen.add(os.path.realpath(folder))

    def _each(self) -> Iterator[tuple[Overrides, Job, int | Seeds]]:
        """Yield what each job of the sweep is told, its checked configuration, and its seed or seeds."""
        for overrides in combinations(self._overrides):
            job = self.jobs[tuple(text for text in overrides if not _is_seed(text))]
            seed = next((int(text.partition("=")[2]) for text in overrides if _is_seed(text)), job.keys.seed)
            yield overrides, job, seed if job.seeds is None else job.seeds

    def _in_store(self) -> dict[tuple[str | None, str, str], Found]:
        """Return the finished runs of the sweep's jobs by where they are and identity, where kept trials count."""
        return {
            (tracker.address, tracker.where, identity): run
            for (tracker, configuration), wanted in self._wanted().items()
            for identity, run in tracker.find(configuration, wanted).items()
        }

    def _wanted(self) -> dict[tuple[Tracker, str], set[str]]:
        """Return the identities that count if they are kept, by their tracker and configuration."""
        wanted: dict[tuple[Tracker, str], set[str]] = {}
        for _, job, seeds in self._each():
            if job.keys.resume and job.report is None:
                setup = job.setup
                wanted.setdefault((job.tracker, setup.configuration_id), set()).add(setup.identity(seeds))
        return wanted


def _composed(loader: ConfigLoader, overrides: Overrides) -> DictConfig:
    """Return the configuration of a job; what its folder's name refers to must be in it.

    Raises:
        OmegaConfBaseException, HydraException: if something is not.
    """
    config = loader.load_configuration("config", overrides, run_mode=RunMode.RUN)
    if not OmegaConf.is_missing(config.hydra.sweep, "subdir"):
        numbered = OmegaConf.merge(config, {"hydra": {"job": {"num": 0, "id": "0"}}})
        _ = numbered.hydra.sweep.subdir
    return config


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


@contextmanager
def only_sweep_in(folder: Path) -> Iterator[None]:
    """Keep other sweeps of this machine out of a folder while this one runs: each would count the other's jobs.

    Raises:
        SettingsError: if another runs there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    handle = os.open(folder, os.O_RDONLY)
    try:
        try:
            flock(handle, LOCK_EX | LOCK_NB)
        except BlockingIOError as problem:
            said = f"hydra.sweep.dir: expected a folder in which no other sweep runs; got {folder}"
            raise SettingsError(said) from problem
        except OSError:  # a disk that has no locks
            pass
        yield
    finally:
        os.close(handle)


def first_number(folder: Path) -> int:
    """Return the number of a sweep's first job: one that no job in its folder, of an earlier sweep, has."""
    numbers = [int(job.name) for job in folder.iterdir() if job.is_dir() and job.name.isdecimal()]
    return max(numbers, default=-1) + 1


def fix_folder(config: DictConfig) -> Path:
    """Name a sweep's folder absolutely, for jobs that are composed elsewhere too; return it."""
    folder = Path(config.hydra.sweep.dir).absolute()
    config.hydra.sweep.dir = literal(str(folder))
    config.hydra.overrides.hydra.append(f"hydra.sweep.dir={hydra_text(str(folder))}")
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
