"""One job: a checked configuration, which becomes a trial, a batch of trials, or a report."""

from __future__ import annotations

import math
import pickle
from functools import lru_cache
from pathlib import Path
from typing import Any

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from acoexp import registry
from acoexp.command import summary
from acoexp.command.messages import print_error
from acoexp.command.parcel import Parcel
from acoexp.command.records import run_batch_job, run_trial_job
from acoexp.errors import SettingsError, StoreGoneError
from acoexp.grid import Grid
from acoexp.report.context import Context
from acoexp.report.report import Report
from acoexp.seeds import Seeds, check_seed, parse_seeds
from acoexp.settings import Settings, resolve
from acoexp.solver import check_threads
from acoexp.tracking import Setup, Tracker, open_tracker
from acoexp.tracking.setup import NOT_OF_THE_TRIAL

_NOT_SETTINGS = ("seed", "algo", "map", *NOT_OF_THE_TRIAL)


def run_job(config: DictConfig) -> float:
    """Run what a configuration describes; return the best length, or a batch's mean of it.

    It is infinite where no ant ever arrived, and nan for a report.

    Raises:
        AcoexpError: for whatever went wrong.
    """
    with Parcel().at_home():  # files and stores are named from there, also under hydra.job.chdir
        try:
            return Job(config).run()
        except StoreGoneError as problem:  # no further job could be kept either, so the sweep ends here
            print_error(problem)
            raise SystemExit(1) from problem


class Job:
    """A checked configuration, ready to run.

    Attributes:
        tracker: Where its results go.
        setup: What its trials are of.
        seeds: The seeds of a batch, or None for a single trial.
        report: The report that is asked for, or None.

    Raises:
        AcoexpError: if anything in it is wrong; nothing has been written then.
    """

    def __init__(self, config: DictConfig) -> None:
        self.config = _plain(config)
        self.tracker: Tracker = open_tracker(self._tracking())
        self.seed = check_seed(self.config.get("seed"))
        seeds = self.config.get("seeds")
        self.seeds: Seeds | None = None if seeds is None else parse_seeds(seeds)
        self.threads: int | None = self.config.get("threads")
        if self.threads is not None:
            check_threads(self.threads)
        self.resume = _check_flag("resume", self.config.get("resume"))
        self.setup = Setup(self._settings(), self._grid(), self.config)
        self.report = self._report()
        if self.report is not None and self.seeds is not None:
            raise SettingsError(f"seeds: expected none with a report, which has keys of its own; got {seeds!r}")
        if self.report is not None:
            self.report.check(self._context(self.report, Path()))

    @property
    def trials(self) -> int:
        """How many trials it is."""
        return 1 if self.seeds is None else len(self.seeds)

    def run(self) -> float:
        """Run the trials and keep what they found, or write the report that is asked for."""
        if self.report is not None:
            return self._write_report(self.report)
        hydra = HydraConfig.get()
        folder = Path(hydra.runtime.output_dir)
        (folder / "config.yaml").write_text(OmegaConf.to_yaml(self.config), encoding="utf-8")
        anew = not self.resume
        if self.seeds is not None:
            return run_batch_job(self.setup, self.seeds, self.tracker, folder, threads=self.threads, anew=anew)
        pictures = hydra.mode == RunMode.RUN
        return run_trial_job(self.setup, self.seed, self.tracker, folder, anew=anew, pictures=pictures)

    def _write_report(self, report: Report) -> float:
        """Write a report: under outputs/reports, or in the job's own folder if it is one of several."""
        hydra, name = HydraConfig.get(), self.config["report"]["name"]
        several = hydra.mode == RunMode.MULTIRUN
        folder = Path(hydra.runtime.output_dir if several else "outputs/reports") / name
        written = report.write(self._context(report, folder))
        summary.print_report(written, report.headline(written))
        return math.nan

    def _context(self, report: Report, folder: Path) -> Context:
        return Context(
            algo=self.config["algo"],
            settings=self.setup.settings,
            grid=self.setup.grid,
            folder=folder,
            tracker=self.tracker,
            threads=self.threads,
            resume=self.resume,
        )

    def _tracking(self) -> dict[str, Any]:
        """Return where results go, by the absolute address if the parent gave one."""
        tracking = self._mapping("tracking")
        absolute = Parcel().addresses.get(str(tracking.get("uri")))
        return tracking if absolute is None else {**tracking, "uri": absolute}

    def _settings(self) -> Settings:
        values = {key: value for key, value in self.config.items() if key not in _NOT_SETTINGS}
        return resolve(self.config.get("algo"), values)

    def _grid(self) -> Grid:
        parameters = dict(self._mapping("map"))
        source = registry.build_part("map", parameters.pop("name", None), parameters)
        return _load(source, Parcel().map_of(self._mapping("map")))

    def _report(self) -> Report | None:
        """Return the report that was asked for, or None."""
        parameters = dict(self._mapping("report"))
        name = parameters.pop("name", None)
        if name != "none":
            report: Report = registry.build_part("report", name, parameters)
            return report
        for key in parameters:
            raise SettingsError(f"report.{key} is not a known key of report=none")
        return None

    def _mapping(self, key: str) -> dict[str, Any]:
        value = self.config.get(key)
        if not isinstance(value, dict):
            raise SettingsError(f"{key}: expected one of the options that --help lists; got {value!r}")
        return value


def _check_flag(key: str, value: Any) -> bool:
    if not isinstance(value, bool):
        raise SettingsError(f"{key}: expected true or false; got {value!r}")
    return value


@lru_cache(maxsize=4)
def _load(source: Any, carried: Path | None) -> Grid:
    """Load a map once for the jobs of a process that share it: as the parent found it, if it sent it along."""
    grid: Grid = source.load() if carried is None else pickle.loads(carried.read_bytes())
    return grid


def _plain(config: DictConfig) -> dict[str, Any]:
    ours = [str(key) for key in config if key != "hydra"]
    try:
        plain = OmegaConf.to_container(OmegaConf.masked_copy(config, ours), resolve=True)
    except OmegaConfBaseException as problem:
        raise SettingsError(str(problem).splitlines()[0]) from problem
    return {str(key): value for key, value in plain.items()} if isinstance(plain, dict) else {}
