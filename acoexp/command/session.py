"""A session: before anything runs or is written, every job is checked and the store prepared, once."""

from __future__ import annotations

import re
import traceback
from pathlib import Path
from typing import Any

from hydra._internal.core_plugins.basic_sweeper import BasicSweeper
from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.override_parser.types import Override
from hydra.core.utils import JobStatus
from hydra.errors import HydraException
from hydra.experimental.callback import Callback
from hydra.types import RunMode
from omegaconf import DictConfig
from omegaconf.errors import OmegaConfBaseException

from acoexp.command import summary, sweep
from acoexp.command.job import Job
from acoexp.command.messages import print_error
from acoexp.command.parcel import Parcel, carry_options
from acoexp.errors import AcoexpError
from acoexp.settings import check_seed
from acoexp.tracking.mlflow_store import MlflowTracker


class Session(Callback):
    """Hydra's callback in the parent process; an error in it ends the program with status 1."""

    def on_run_start(self, config: DictConfig, **_: Any) -> None:
        """Check the one job."""
        _or_exit(lambda: Job(config).tracker.prepare())

    def on_multirun_start(self, config: DictConfig, **_: Any) -> None:
        """Check all jobs, and begin to watch over them."""
        _or_exit(lambda: _begin_sweep(config))

    def on_run_end(self, config: DictConfig, **kwargs: Any) -> None:
        """Tell what the one job found."""
        folder, ended = Path(config.hydra.run.dir), kwargs["job_return"]
        if ended.status == JobStatus.COMPLETED and (folder / "trial.json").exists():
            summary.print_trial(folder, Job(config).tracker.where)


def _or_exit(action: Any) -> None:
    """Hydra turns a callback's exceptions into warnings, but lets this one through."""
    try:
        action()
    except (AcoexpError, HydraException, OmegaConfBaseException, OSError) as problem:
        print_error(problem)
        raise SystemExit(1) from problem
    except Exception as problem:
        traceback.print_exc()
        raise SystemExit(1) from problem


def _begin_sweep(config: DictConfig) -> None:
    loader = GlobalHydra.instance().config_loader()
    carry_options(loader)
    parsed = OverridesParser.create(config_loader=loader).parse_overrides(list(config.hydra.overrides.task))
    basic = config.hydra.sweeper._target_ == f"{BasicSweeper.__module__}.{BasicSweeper.__qualname__}"
    if not basic:  # what its values will be, only the sweeper knows
        parsed = [override for override in parsed if not override.is_sweep_override()]
    others = [override for override in parsed if override.key_or_group != "seed"]
    for seed in (value for override in parsed if override not in others for value in _values(override)):
        _check_seed_text(seed)
    trackers, maps, report = {}, [], None
    for combination in BasicSweeper.split_arguments(others, None)[0]:
        overrides = [*combination, *config.hydra.overrides.hydra]
        job = Job(loader.load_configuration("config", overrides, run_mode=RunMode.RUN))
        trackers[job.tracker.where], report = job.tracker, job.report
        maps.append((job.config["map"], job.grid))
        if isinstance(job.tracker, MlflowTracker):
            Parcel().addresses[job.config["tracking"]["uri"]] = job.tracker.uri
    # Hydra would compose every job once more to see whether it is legal: 40 s of silence for 500 of them
    BasicSweeper.validate_batch_is_legal = lambda *_: None  # type: ignore[method-assign]
    for tracker in trackers.values():
        tracker.prepare()
    folder = _fix_folder(config)
    Parcel().pack(folder, maps)
    if report is None:
        total = len(BasicSweeper.split_arguments(parsed, None)[0]) if basic else None
        sweep.begin(folder, total, ", ".join(trackers))


def _fix_folder(config: DictConfig) -> Path:
    """Name the sweep's folder absolutely, for jobs that are composed elsewhere too; return it."""
    folder = Path(config.hydra.sweep.dir).absolute()
    config.hydra.sweep.dir = str(folder)
    quoted = str(folder).replace("'", r"\'")
    config.hydra.overrides.hydra.append(f"hydra.sweep.dir='{quoted}'")
    return folder


def _values(override: Override) -> list[str]:
    if override.is_sweep_override():
        return list(override.sweep_string_iterator())
    return [override.get_value_element_as_str()]


def _check_seed_text(text: str) -> None:
    check_seed(int(text) if re.fullmatch("0|[1-9][0-9]*", text) else text)
