"""One job: a resolved configuration becomes a trial, is tracked, and leaves its files in the job's folder."""

from __future__ import annotations

import json
import math
import pickle
import time
from functools import lru_cache
from pathlib import Path
from typing import Any

from hydra.core.hydra_config import HydraConfig
from hydra.types import RunMode
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from acoexp import registry
from acoexp.command import summary
from acoexp.command.parcel import Parcel
from acoexp.errors import SettingsError
from acoexp.grid import Grid
from acoexp.parameters import build
from acoexp.report.context import Context
from acoexp.report.report import Report
from acoexp.settings import Settings, check_seed, resolve
from acoexp.solver import Solver
from acoexp.tracking import Tracker, Trial, open_tracker
from acoexp.tracking.tracker import NoTracker


def run_job(config: DictConfig) -> float:
    """Run the trial that a configuration describes; return its best length.

    Raises:
        AcoexpError: for whatever went wrong.
    """
    with Parcel().at_home():  # files and stores are named from there, also under hydra.job.chdir
        return Job(config).run()


class Job:
    """A checked configuration, ready to run.

    Raises:
        AcoexpError: if anything in it is wrong; nothing has been written then.
    """

    def __init__(self, config: DictConfig) -> None:
        self.config = _plain(config)
        self.tracker: Tracker = open_tracker(self._tracking())
        self.seed = check_seed(self.config.get("seed"))
        self.settings = self._settings()
        self.grid = self._grid()
        self.report = self._report()
        if self.report is not None:
            self.tracker = NoTracker()
            self.report.check(self._context(Path()))

    def run(self) -> float:
        """Run the trial and keep what it found, or write the report that is asked for."""
        if self.report is not None:
            return self._write_report(self.report)
        solver = Solver(self.grid, self.settings)
        began = time.perf_counter()
        result = solver.solve(self.seed)
        seconds = time.perf_counter() - began
        trial = Trial(result, self.config)
        hydra = HydraConfig.get()
        folder = Path(hydra.runtime.output_dir)
        (folder / "config.yaml").write_text(OmegaConf.to_yaml(self.config), encoding="utf-8")
        if hydra.mode == RunMode.RUN:
            from acoexp.command.pictures import draw_convergence, draw_map

            draw_map(result, folder / "path.png")
            draw_convergence(result, folder / "convergence.png")
        content = {**result.as_dict(), "seconds": seconds, "cell": trial.cell, "config": trial.params}
        self.tracker.log(trial)
        _write_whole(folder / "trial.json", json.dumps(content))
        return result.length

    def _write_report(self, report: Report) -> float:
        """Write a report: under outputs/reports, or in the job's own folder if it is one of several."""
        hydra, name = HydraConfig.get(), self.config["report"]["name"]
        several = hydra.mode == RunMode.MULTIRUN
        folder = Path(hydra.runtime.output_dir if several else "outputs/reports") / name
        written = report.write(self._context(folder))
        summary.print_report(written, report.headline(written))
        return math.nan

    def _context(self, folder: Path) -> Context:
        return Context(self.config["algo"], self.settings, self.grid, folder)

    def _tracking(self) -> dict[str, Any]:
        """Return where results go, by the absolute address if the parent gave one."""
        tracking = self._mapping("tracking")
        absolute = Parcel().addresses.get(str(tracking.get("uri")))
        return tracking if absolute is None else {**tracking, "uri": absolute}

    def _settings(self) -> Settings:
        others = ("seed", "algo", "map", "tracking", "report")
        values = {key: value for key, value in self.config.items() if key not in others}
        return resolve(self.config.get("algo"), values)

    def _grid(self) -> Grid:
        parameters = dict(self._mapping("map"))
        name = parameters.pop("name", None)
        source = build(registry.find("map", name), parameters, "map.")
        return _load(source, Parcel().map_of(self._mapping("map")))

    def _report(self) -> Report | None:
        """Return the report that was asked for, or None."""
        parameters = dict(self._mapping("report"))
        name = parameters.pop("name", None)
        if name != "none":
            report: Report = build(registry.find("report", name), parameters, "report.")
            return report
        for key in parameters:
            raise SettingsError(f"report.{key} is not a known key of report=none")
        return None

    def _mapping(self, key: str) -> dict[str, Any]:
        value = self.config.get(key)
        if not isinstance(value, dict):
            raise SettingsError(f"{key}: expected one of the options that --help lists; got {value!r}")
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


def _write_whole(file: Path, text: str) -> None:
    """Write a file so that it is there whole or not at all; its presence says that the trial is finished."""
    draft = file.with_suffix(".draft")
    draft.write_text(text, encoding="utf-8")
    draft.replace(file)
