"""One job: a checked configuration, which becomes a trial, a batch of trials, or a report."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from contextlib import nullcontext
from copy import copy
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf

from acoexp.command.alone import keep_alone
from acoexp.command.dumping import yaml_of
from acoexp.command.handover import Handover
from acoexp.command.options.keys import JobKeys
from acoexp.command.options.quoting import literal
from acoexp.command.reporting import Asked, asked_report
from acoexp.command.results.again import command_of
from acoexp.command.results.artifacts import carried, pictured
from acoexp.command.results.contents import batch_record, trial_record
from acoexp.command.results.records import BATCH, FAILED_JOB, TRIAL, write_progress, write_record
from acoexp.command.results.table import print_report
from acoexp.command.results.watch import Watched, watching
from acoexp.console.collecting import collect_from_now_on
from acoexp.console.whole import whole_file, write_whole
from acoexp.errors import AcoexpError, SettingsError, StrategyError
from acoexp.grid.grid import Grid
from acoexp.parameters import build, fields_of
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.runs.batch import keep_batch, kept_trials
from acoexp.runs.trial import keep_trial
from acoexp.tracking.open import open_tracker
from acoexp.tracking.setup import Setup
from acoexp.tracking.tracker import Tracker
from acoexp.trial.outcome import Batch
from acoexp.trial.seeds import Seeds, parse_seeds
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver
from acoexp.trial.table import csv_lines

_NOT_SETTINGS = {"algo", "map", "report", "tracking", *fields_of(JobKeys)}


class Job:
    """A checked configuration, ready to run.

    Attributes:
        config: The configuration as plain values.
        keys: Which trials it is, and how they are run.
        seeds: The seeds of a batch, or None for a single trial.
        tracker: Where its results go.
        setup: What its trials are of.
        report: The report that is asked for, with its folder, or None.

    Raises:
        AcoexpError, OmegaConfBaseException: if anything in it is wrong; nothing has been written then.
    """

    def __init__(self, config: dict[str, Any], handover: Handover) -> None:
        self.config = config
        self._handover = handover
        self.tracker: Tracker = open_tracker(self._tracking())
        self.keys, self.seeds = self._keys()
        self.setup = Setup(self._settings(), self._grid(), self._mapping("map"))
        self.report = self._report()
        self._solver: Callable[[], Solver] = cache(partial(Solver, self.setup.grid, self.setup.settings))

    def with_seed(self, seed: object) -> Job:
        """Return the job with another seed; what it takes to run it is made once for both.

        Raises:
            SettingsError: if it is no seed.
        """
        job = copy(self)
        job.config = {**self.config, "seed": seed}
        job.keys, job.seeds = job._keys()
        return job

    @property
    def trials(self) -> int:
        """How many trials it is."""
        return 1 if self.seeds is None else len(self.seeds)

    def prepare(self) -> None:
        """Make the store ready; before a trial, which is shown first, take no more than a quick look at it.

        Raises:
            TrackingError: if it cannot be written.
        """
        if self.report is None and self.seeds is None:
            self.tracker.check()
        else:
            self.tracker.prepare()
            collect_from_now_on()

    def run(self) -> float:
        """Run the trials and keep what they found, or write the report; return the best length, or its mean.

        It is infinite where no ant ever arrived, and nan for a report.
        """
        hydra = HydraConfig.get()
        alone = hydra.mode == RunMode.RUN
        folder = Path(hydra.runtime.output_dir)
        if not alone:
            folder = self._handover.own_folder(folder)
        try:
            return self._run_in(folder, alone)
        except AcoexpError as problem:
            write_whole(folder / FAILED_JOB, f"{problem}\n")
            raise

    def _run_in(self, folder: Path, alone: bool) -> float:
        if self.report is not None:
            print_report(*self.report.write(self._context(self.report, self.report.place(folder))))
            return math.nan
        address = str(self._mapping("tracking").get("uri", ""))
        write_whole(folder / "config.yaml", yaml_of(literal(self.config), address))
        if self.seeds is None:
            return self._run_trial(folder, alone)
        watched = Watched(folder=folder, where=self.tracker.where, trials=len(self.seeds))
        with watching(watched) if alone else nullcontext():
            return self._run_batch(folder, self.seeds)

    def _run_trial(self, folder: Path, alone: bool) -> float:
        """Run one trial; the only one is shown before it is kept."""
        setup, keys = self._setup_with_command(), self.keys
        keep = partial(keep_trial, setup, keys.seed, self.tracker, solver=self._solver, resume=keys.resume)
        if alone:
            trial = keep_alone(keep, self.tracker, folder, Path(HydraConfig.get().run.dir))
        else:
            trial = keep(artifacts=carried)
            write_record(folder / TRIAL, trial_record(trial))
        return trial.result.length if trial.result.path is not None else math.inf

    def _run_batch(self, folder: Path, seeds: Seeds) -> float:
        """Run what is missing of a batch.

        Raises:
            StrategyError: if any of its trials failed; all others have been run and kept.
        """
        batch = keep_batch(
            self._setup_with_command(),
            seeds,
            self.tracker,
            threads=self.keys.threads,
            resume=self.keys.resume,
            artifacts=partial(pictured, folder),
            show=partial(write_progress, folder),
        )
        if len(batch.table):
            with whole_file(folder / "trials.csv") as draft, draft.open("w", encoding="utf-8") as file:
                file.writelines(f"{line}\n" for line in csv_lines(batch.table))
            write_record(folder / BATCH, batch_record(self.setup, seeds, batch))
        _raise_if_failed(batch, len(seeds))
        lengths = batch.table["l1"]
        return math.inf if np.isnan(lengths).any() else float(lengths.mean())

    def _context(self, asked: Asked, folder: Path) -> Context:
        algo, keys = self.config["algo"], self.keys
        return Context(
            algo=algo,
            preset=resolve(algo, {}),
            settings=self.setup.settings,
            grid=self.setup.grid,
            seed=keys.seed,
            folder=folder,
            trials_of=partial(
                kept_trials,
                tracker=self.tracker,
                threads=keys.threads,
                resume=keys.resume,
                artifacts=carried,
            ),
            made_by={
                "report": asked.given,
                "settings": self.setup.settings.as_dict(),
                "map": [self.setup.grid.name, self.setup.grid.digest],
                "seed": keys.seed,
            },
        )

    def _setup_with_command(self) -> Setup:
        """Return the setup with the command that runs this job alone, but for where it is kept."""
        hydra = HydraConfig.get()
        own = (source.path for source in hydra.runtime.config_sources if source.provider == "command-line")
        return replace(self.setup, command=command_of(hydra.overrides.task, next(own, None)))

    def _keys(self) -> tuple[JobKeys, Seeds | None]:
        given = {key: self.config.get(key) for key in fields_of(JobKeys)}
        seeds = None if given["seeds"] is None else parse_seeds(given["seeds"])
        keys: JobKeys = build(JobKeys, {**given, "seeds": None if seeds is None else str(seeds)})
        return keys, seeds

    def _tracking(self) -> dict[str, Any]:
        """Return where results go, by the absolute address if the parent gave one."""
        tracking = dict(self._mapping("tracking"))
        if tracking.get("experiment", "") is None:
            tracking["experiment"] = self._handover.experiment or None
        absolute = self._handover.addresses.get(str(tracking.get("uri")))
        return tracking if absolute is None else {**tracking, "uri": absolute}

    def _settings(self) -> Settings:
        values = {key: value for key, value in self.config.items() if key not in _NOT_SETTINGS}
        return resolve(self.config.get("algo"), values)

    def _grid(self) -> Grid:
        config = self._mapping("map")
        handed_over = self._handover.map_of(config)
        if handed_over is not None:
            return handed_over
        parameters = dict(config)
        return load_map(parameters.pop("name", None), **parameters)

    def _report(self) -> Asked | None:
        """Return the report that was asked for, checked, or None."""
        asked = asked_report(self._mapping("report"))
        if asked is None:
            return None
        if self.seeds is not None:
            raise SettingsError(
                f"seeds: expected none with a report, which has keys of its own; got {self.config['seeds']!r}"
            )
        asked.report.check(self._context(asked, Path()))
        return asked

    def _mapping(self, key: str) -> Mapping[str, Any]:
        value = self.config.get(key)
        if not isinstance(value, dict):
            raise SettingsError(f"{key}: expected one of the options that --help lists; got {value!r}")
        return value


def _raise_if_failed(batch: Batch, trials: int) -> None:
    if batch.failures:
        raise StrategyError(f"{len(batch.failures)} of {trials} trials failed: {batch.failures[0].reason}")


def plain(config: DictConfig) -> dict[str, Any]:
    """Return what a configuration says, but for Hydra's own part: resolved, as plain values."""
    if "hydra" in config:
        config = OmegaConf.masked_copy(config, [str(key) for key in config if key != "hydra"])
    values = OmegaConf.to_container(config, resolve=True)
    return {str(key): value for key, value in values.items()} if isinstance(values, dict) else {}
