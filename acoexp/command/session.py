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
from hydra.errors import HydraException
from hydra.experimental.callback import Callback
from hydra.types import RunMode
from omegaconf import DictConfig

from acoexp.command import summary, sweep
from acoexp.command.job import Job
from acoexp.command.messages import print_error
from acoexp.errors import AcoexpError
from acoexp.settings import check_seed


class Session(Callback):
    """Hydra's callback in the parent process; an error in it ends the program with status 1."""

    def on_run_start(self, config: DictConfig, **_: Any) -> None:
        """Check the one job."""
        _or_exit(lambda: Job(config).tracker.prepare())

    def on_multirun_start(self, config: DictConfig, **_: Any) -> None:
        """Check all jobs, and begin to watch over them."""
        _or_exit(lambda: _begin_sweep(config))

    def on_run_end(self, config: DictConfig, **_: Any) -> None:
        """Tell what the one job found."""
        folder = Path(config.hydra.run.dir)
        if (folder / "trial.json").exists():
            summary.print_trial(folder, Job(config).tracker.where)


def _or_exit(action: Any) -> None:
    """Hydra turns a callback's exceptions into warnings, but lets this one through."""
    try:
        action()
    except (AcoexpError, HydraException, OSError) as problem:
        print_error(problem)
        raise SystemExit(1) from problem
    except Exception as problem:
        traceback.print_exc()
        raise SystemExit(1) from problem


def _begin_sweep(config: DictConfig) -> None:
    loader = GlobalHydra.instance().config_loader()
    parsed = OverridesParser.create(config_loader=loader).parse_overrides(list(config.hydra.overrides.task))
    jobs = BasicSweeper.split_arguments(parsed, None)[0]
    seeds = [override for override in parsed if override.key_or_group == "seed"]
    others = [override for override in parsed if override.key_or_group != "seed"]
    for seed in (value for override in seeds for value in _values(override)):
        _check_seed_text(seed)
    for combination in BasicSweeper.split_arguments(others, None)[0]:
        job = Job(
            loader.load_configuration(
                "config", [*combination, *config.hydra.overrides.hydra], run_mode=RunMode.RUN
            )
        )
    job.tracker.prepare()
    sweep.begin(Path(config.hydra.sweep.dir), len(jobs), job.tracker.where)


def _values(override: Override) -> list[str]:
    if override.is_sweep_override():
        return list(override.sweep_string_iterator())
    return [override.get_value_element_as_str()]


def _check_seed_text(text: str) -> None:
    check_seed(int(text) if re.fullmatch("0|[1-9][0-9]*", text) else text)
