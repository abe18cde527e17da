"""A session: before anything runs or is written, every job is checked and the store prepared, once."""

from __future__ import annotations

import re
import sys
import traceback
from collections.abc import Collection
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
from acoexp.command.outcome import record_of
from acoexp.command.parcel import Parcel, carry_options
from acoexp.command.records import TRIAL
from acoexp.errors import AcoexpError
from acoexp.seeds import check_seed
from acoexp.tracking.mlflow_tracker import MlflowTracker


class Session(Callback):
    """Hydra's callback in the parent process; an error in it ends the program with status 1."""

    def on_run_start(self, config: DictConfig, **_: Any) -> None:
        """Check the one job."""
        _or_exit(lambda: _begin_run(config))

    def on_multirun_start(self, config: DictConfig, **_: Any) -> None:
        """Check all jobs, leave out those that are in the store, and begin to watch over the others."""
        _or_exit(lambda: _begin_sweep(config))

    def on_run_end(self, config: DictConfig, **kwargs: Any) -> None:
        """Tell what the one job found."""
        folder, ended = Path(config.hydra.run.dir), kwargs["job_return"]
        if ended.status == JobStatus.COMPLETED and (folder / TRIAL).exists():
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


def _begin_run(config: DictConfig) -> None:
    job = Job(config)
    job.tracker.prepare()
    if job.seeds is not None and job.report is None:
        sweep.begin(Path(config.hydra.run.dir), len(job.seeds), job.tracker.where)


def _begin_sweep(config: DictConfig) -> None:
    loader = GlobalHydra.instance().config_loader()
    carry_options(loader)
    parsed = OverridesParser.create(config_loader=loader).parse_overrides(list(config.hydra.overrides.task))
    # what another sweeper will choose, only that one knows
    basic = config.hydra.sweeper._target_ == f"{BasicSweeper.__module__}.{BasicSweeper.__qualname__}"
    known = parsed if basic else [override for override in parsed if not override.is_sweep_override()]
    for override in known:
        if override.key_or_group == "seed":
            _check_seeds(override)
    others = [override for override in known if override.key_or_group != "seed"]
    jobs: dict[tuple[str, ...], Job] = {}
    for combination in BasicSweeper.split_arguments(others, None)[0]:
        overrides = [*combination, *config.hydra.overrides.hydra]
        jobs[tuple(combination)] = Job(loader.load_configuration("config", overrides, run_mode=RunMode.RUN))
    trackers = {job.tracker.where: job.tracker for job in jobs.values()}
    for tracker in trackers.values():
        tracker.prepare()
    where, folder = ", ".join(trackers), _fix_folder(config)
    _pack(folder, jobs.values())
    if any(job.report is not None for job in jobs.values()):
        return
    if basic:
        _leave_out_what_is_there(jobs, parsed, folder, where)
    else:
        sweep.begin(folder, None, where)


def _pack(folder: Path, jobs: Collection[Job]) -> None:
    """Put into the sweep's folder, and into what launchers carry, all that a worker needs of this machine."""
    for job in jobs:
        if isinstance(job.tracker, MlflowTracker):
            Parcel().addresses[job.config["tracking"]["uri"]] = job.tracker.store.uri
    Parcel().pack(folder, [(job.config["map"], job.setup.grid) for job in jobs])


def _fix_folder(config: DictConfig) -> Path:
    """Name the sweep's folder absolutely, for jobs that are composed elsewhere too; return it."""
    folder = Path(config.hydra.sweep.dir).absolute()
    config.hydra.sweep.dir = str(folder)
    quoted = str(folder).replace("'", r"\'")
    config.hydra.overrides.hydra.append(f"hydra.sweep.dir='{quoted}'")
    return folder


def _leave_out_what_is_there(
    jobs: dict[tuple[str, ...], Job], parsed: list[Override], folder: Path, where: str
) -> None:
    """Let the sweeper run only the jobs whose results are not in the store."""
    in_store = {job.setup.cell: job.tracker.find(job.setup.cell) for job in jobs.values() if job.resume}
    missing, there, found, total = [], [], 0, 0
    for arguments in BasicSweeper.split_arguments(parsed, None)[0]:
        job = jobs[tuple(a for a in arguments if not _is_seed(a))]
        seed = next((a.partition("=")[2] for a in arguments if _is_seed(a)), str(job.seed))
        identity = job.setup.identity(seed if job.seeds is None else job.seeds)
        run = in_store.get(job.setup.cell, {}).get(identity)
        total += job.trials
        if run is None:
            missing.append(arguments)
        else:
            there.append(record_of(job.setup, run))
            found += job.trials
    if found:
        print(f"acoexp: {found} of {total} trials found in the store", file=sys.stderr)
    batches = [missing] if missing else []
    BasicSweeper.split_arguments = staticmethod(lambda *_: batches)  # type: ignore
    # Hydra would compose every job once more to see whether it is legal: 40 s of silence for 500 of them
    BasicSweeper.validate_batch_is_legal = lambda *_: None  # type: ignore[method-assign]
    sweep.begin(folder, total, where, there, found)


def _is_seed(argument: str) -> bool:
    return argument.lstrip("+").partition("=")[0] == "seed"


def _check_seeds(override: Override) -> None:
    sweeps = override.is_sweep_override()
    for text in override.sweep_string_iterator() if sweeps else [override.get_value_element_as_str()]:
        check_seed(int(text) if re.fullmatch("0|[1-9][0-9]*", text) else text)
