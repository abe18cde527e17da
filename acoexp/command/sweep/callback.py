"""Hydra's callback in the parent process: it checks the one job before it runs, or a foreign sweeper's."""

from __future__ import annotations

import atexit
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.errors import HydraException
from hydra.experimental.callback import Callback
from omegaconf import DictConfig, OmegaConf
from omegaconf.errors import OmegaConfBaseException

from acoexp.command.handover import Handover
from acoexp.command.job import Job
from acoexp.command.messages import in_one_line
from acoexp.command.results.watch import Watch, Watched
from acoexp.command.sweep.plan import Plan, as_written, fix_folder
from acoexp.console.ending import FAILED, print_error
from acoexp.console.whole import write_whole
from acoexp.errors import AcoexpError, SettingsError
from acoexp.tracking.mlflow.masking import masked

OWN_SWEEPER = "hydra_plugins.acoexp.sweeper.AcoexpSweeper"
"""It checks and watches its jobs itself."""


class Session(Callback):
    """One run of the program; an error in it ends the program with status 1."""

    def on_run_start(self, config: DictConfig, **_: Any) -> None:
        """Check the one job and make its store ready."""
        _or_exit(lambda: _begin_run(config))

    def on_multirun_start(self, config: DictConfig, **_: Any) -> None:
        """Check what is known of the jobs that another sweeper will choose, and begin to watch over them."""
        if config.hydra.sweeper._target_ != OWN_SWEEPER:
            _or_exit(lambda: _begin_foreign_sweep(config))

    def on_job_start(self, config: DictConfig, **_: Any) -> None:
        """Mask the passwords of addresses in what Hydra has just written of a job's configuration."""
        if config.hydra.output_subdir is not None:
            folder = Path(config.hydra.runtime.output_dir, config.hydra.output_subdir)
            address = str(OmegaConf.select(config, "tracking.uri", default=""))
            for file in folder.glob("*.yaml"):
                write_whole(file, masked(file.read_text(encoding="utf-8"), address))


def _or_exit(action: Callable[[], None]) -> None:
    """Hydra turns a callback's exceptions into warnings, but lets this one through."""
    try:
        action()
    except (AcoexpError, HydraException, OmegaConfBaseException, OSError) as problem:
        print_error(in_one_line(problem))
        raise SystemExit(FAILED) from problem
    except Exception as problem:
        traceback.print_exc()
        raise SystemExit(FAILED) from problem


def _begin_run(config: DictConfig) -> None:
    handover = Handover()
    job = Job(config, handover)
    job.tracker.prepare()
    handover.ready = job.run


def _check_storage(storage: str | None) -> None:
    """Refuse to keep a study of Optuna's in a database: Optuna 2 fails at that with SQLAlchemy 2."""
    if storage is not None and not storage.startswith("redis"):
        raise SettingsError(
            "hydra.sweeper.storage: expected nothing, or redis://...; Optuna 2, which Hydra's sweeper needs, "
            "cannot keep a study in a database by the SQLAlchemy that MLflow needs"
        )


def _begin_foreign_sweep(config: DictConfig) -> None:
    _check_storage(config.hydra.sweeper.get("storage"))
    loader = GlobalHydra.instance().config_loader()
    texts = as_written(config.hydra.overrides.task)
    parsed = OverridesParser.create(config_loader=loader).parse_overrides(texts)
    plan = Plan(config, loader, [override for override in parsed if not override.is_sweep_override()])
    folder = fix_folder(config)
    plan.prepare(folder)
    if not plan.has_reports:
        # however it ends: Hydra tells a callback of a good end alone
        atexit.register(Watch(Watched(folder=folder, where=plan.where)).end)
