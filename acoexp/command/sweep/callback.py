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
from hydra.types import RunMode
from omegaconf import DictConfig
from omegaconf.errors import OmegaConfBaseException

from acoexp.command.handover import Handover
from acoexp.command.job import Job, plain
from acoexp.command.messages import in_one_line
from acoexp.command.results.watch import Watch, Watched
from acoexp.command.sweep.plan import Plan, fix_folder
from acoexp.command.sweep.secrets import without_secrets
from acoexp.command.sweep.told import as_written
from acoexp.console.ending import FAILED, print_error
from acoexp.console.whole import write_whole
from acoexp.errors import AcoexpError

OWN_SWEEPERS = ("hydra_plugins.acoexp.sweeper.AcoexpSweeper", "hydra_plugins.acoexp.tuner.OptunaSweeper")
"""They check and watch their jobs themselves."""
OWN_LAUNCHER = "hydra_plugins.acoexp.launcher.AcoexpLauncher"
"""It writes none."""


class Session(Callback):
    """One run of the program; an error in it ends the program with status 1."""

    def on_run_start(self, config: DictConfig, **_: Any) -> None:
        """Check the one job and make its store ready."""
        _or_exit(lambda: _begin_run(config))

    def on_multirun_start(self, config: DictConfig, **_: Any) -> None:
        """Check what is known of the jobs that another sweeper will choose, and begin to watch over them."""
        if config.hydra.sweeper._target_ not in OWN_SWEEPERS:
            _or_exit(lambda: _begin_foreign_sweep(config))

    def on_job_start(self, config: DictConfig, **_: Any) -> None:
        """Mask the passwords of addresses in what Hydra has just written of a job's configuration."""
        in_sweep = config.hydra.mode == RunMode.MULTIRUN  # a single job is Hydra's own, whatever launcher is named
        written_by_us = in_sweep and config.hydra.launcher._target_ == OWN_LAUNCHER
        if config.hydra.output_subdir is not None and not written_by_us:
            folder = Path(config.hydra.runtime.output_dir, config.hydra.output_subdir)
            for file in folder.glob("*.yaml"):
                write_whole(file, without_secrets(file.read_text(encoding="utf-8"), config))


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
    job = Job(plain(config), handover)
    job.prepare()
    handover.ready = job.run


def _begin_foreign_sweep(config: DictConfig) -> None:
    loader = GlobalHydra.instance().config_loader()
    texts = as_written(config.hydra.overrides.task)
    parsed = OverridesParser.create(config_loader=loader).parse_overrides(texts)
    plan = Plan(config, loader, [override for override in parsed if not override.is_sweep_override()])
    folder = fix_folder(config)
    plan.prepare(folder)
    if not plan.has_reports:
        # however it ends: Hydra tells a callback of a good end alone
        atexit.register(Watch(Watched(folder=folder, where=plan.where)).end)
