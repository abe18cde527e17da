"""The plan of a sweep: every job is checked before anything runs; those that are kept are left out."""

from __future__ import annotations

import os
import pickle
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from fcntl import LOCK_EX, LOCK_NB, flock
from pathlib import Path
from typing import Any, NamedTuple

from hydra.core.config_loader import ConfigLoader
from hydra.core.override_parser.types import Override
from omegaconf import DictConfig

from acoexp.command.handover import Handover
from acoexp.command.job import Job, plain
from acoexp.command.options.quoting import hydra_text, literal
from acoexp.command.options.sources import remember_options
from acoexp.command.results.contents import found_record
from acoexp.command.sweep.told import (
    Overrides,
    as_written,
    check_seeds,
    combinations,
    composed,
    has_references,
    is_seed,
    values_of,
)
from acoexp.console.collecting import collect_from_now_on
from acoexp.errors import SettingsError, shown
from acoexp.tracking.setup import Found
from acoexp.tracking.tracker import Tracker
from acoexp.trial.seeds import Seeds


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
        of_hydra = as_written(config.hydra.overrides.hydra)
        seeds = {one.get_key_element(): one for one in overrides if one.key_or_group == "seed"}
        if len(seeds) > 1:
            raise SettingsError(f"seed: expected to be told once; got {' and '.join(seeds)}")
        # a configuration is composed once for all of them
        others = [override for override in overrides if override.key_or_group != "seed"]
        for override in seeds.values():
            check_seeds(override)
        self._seeds = [text for one in seeds.values() for text in values_of(one)] if told is None else []
        self.jobs = dict[tuple[str, ...], Job]()
        for combination in combinations(others) if told is None else told:
            self._add(combination, composed(loader, [*combination, *of_hydra]))
        self.trackers = {job.tracker.where: job.tracker for job in self.jobs.values()}
        self.where = ", ".join(self.trackers)
        self.has_reports = any(job.report is not None for job in self.jobs.values())
        if self.has_reports and told is None:
            self._check_report_folders()

    def _add(self, told: Overrides, config: DictConfig) -> None:
        """Check a configuration; with each seed of the sweep where something else in it is another then."""
        if not (self._seeds and has_references(config)):
            self.jobs[tuple(told)] = Job(plain(config), self._handover)
            return
        made: dict[bytes, Job] = {}
        for seed in self._seeds:
            config.seed = int(seed)
            values = plain(config)
            others = pickle.dumps({key: value for key, value in values.items() if key != "seed"})
            if others not in made:
                made[others] = Job(values, self._handover)
            self.jobs[*told, f"seed={seed}"] = made[others]

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
        collect_from_now_on()

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
            seeds = [text for text in overrides if is_seed(text)]
            others = [text for text in overrides if not is_seed(text)]
            numbers = [text.partition("=")[2] for text in seeds]
            job = self.jobs.get(tuple(others)) or self.jobs[*others, f"seed={numbers[0]}"]
            seed = int(numbers[0]) if numbers else job.keys.seed
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
