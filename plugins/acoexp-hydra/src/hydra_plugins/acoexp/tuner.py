"""``hydra/sweeper=optuna``: Optuna chooses the values of each job by what the jobs before it returned."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.plugins import Plugins
from hydra.core.utils import JobReturn
from hydra.plugins.launcher import Launcher
from hydra.plugins.sweeper import Sweeper
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig, OmegaConf

if TYPE_CHECKING:
    from acoexp.command.options.tuning import TuningKeys
    from acoexp.command.tuning.space import Space
    from acoexp.command.tuning.study import Study

# The sweeper's keys are declared in acoexp/command/options/tuning.py and registered by acoexp's command alone: Hydra
# imports this file in every program that uses it, and others may have a hydra/sweeper=optuna of their own.


class OptunaSweeper(Sweeper):
    """Checks the ends of a space before the first job runs, then runs what a study asks for."""

    def __init__(self, **_: Any) -> None:
        """Take whatever the configuration has; it is checked when the sweep begins."""

    def setup(self, *, hydra_context: HydraContext, task_function: TaskFunction, config: DictConfig) -> None:
        """Take what Hydra gives to every sweeper."""
        self.config: DictConfig = config
        self.loader = hydra_context.config_loader
        self.launcher: Launcher = Plugins.instance().instantiate_launcher(
            hydra_context=hydra_context, task_function=task_function, config=config
        )

    def sweep(self, arguments: list[str]) -> list[JobReturn]:
        """Run the trials that were asked for, beginning or going on with a study; return what its jobs returned."""
        from acoexp.command.options.tuning import read_tuning
        from acoexp.command.results.watch import Watched, watching
        from acoexp.command.sweep.plan import fix_folder, only_sweep_in
        from acoexp.command.sweep.secrets import without_secrets
        from acoexp.command.tuning.space import Space
        from acoexp.command.tuning.study import Study
        from acoexp.console.whole import write_whole

        values: dict[str, Any] = OmegaConf.to_container(self.config.hydra.sweeper, resolve=True)  # type: ignore[assignment]
        del values["_target_"]
        params = values.pop("params") or {}
        keys, *sampler = read_tuning(values)
        texts = [*(f"{key}={value}" for key, value in params.items()), *arguments]
        space = Space(OverridesParser.create(config_loader=self.loader).parse_overrides(texts))
        plan = checked_plan(self.config, self.loader, space)
        study = Study(keys, sampler, space)
        ...
