"""``hydra/sweeper=acoexp``, the default: every combination of the values given, but for what is in the store."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from contextlib import ExitStack

from hydra.core.config_store import ConfigStore
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.plugins import Plugins
from hydra.core.utils import JobReturn
from hydra.plugins.launcher import Launcher
from hydra.plugins.sweeper import Sweeper
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig, OmegaConf

ConfigStore.instance().store(
    group="hydra/sweeper",
    name="acoexp",
    node={
        "_target_": "hydra_plugins.acoexp.sweeper.AcoexpSweeper",
        # the keys of Hydra's basic sweeper
        "max_batch_size": None,
        "params": None,
    },
    provider="acoexp",
)


class AcoexpSweeper(Sweeper):
    """Checks all jobs before the first one runs, leaves out those that are kept, and watches over the others."""

    def __init__(self, max_batch_size: int | None, params: dict[str, str] | None = None) -> None:
        """Take the keys of its configuration: jobs that are launched together at most; further overrides."""
        self.max_batch_size = max_batch_size
        self.params = params or {}

    def setup(self, *, hydra_context: HydraContext, task_function: TaskFunction, config: DictConfig) -> None:
        """Take what Hydra gives to every sweeper."""
        self.config: DictConfig = config
        self.loader = hydra_context.config_loader
        self.launcher: Launcher = Plugins.instance().instantiate_launcher(
            hydra_context=hydra_context, task_function=task_function, config=config
        )

    def sweep(self, arguments: list[str]) -> list[Sequence[JobReturn]]:
        """Run the sweep that the command line's overrides describe; return what its jobs returned."""
        from acoexp.command.results.watch import Watched, watching
        from acoexp.command.sweep.plan import (  # Hydra imports this file at every command
            Plan,
            first_number,
            fix_folder,
            only_sweep_in,
        )
        from acoexp.command.sweep.secrets import without_secrets
        from acoexp.console.whole import write_whole

        texts = [*(f"{key}={value}" for key, value in self.params.items()), *arguments]
        overrides = OverridesParser.create(config_loader=self.loader).parse_overrides(texts)
        plan = Plan(self.config, self.loader, overrides)
        folder = fix_folder(self.config)
        with ExitStack() as stack:
            if not plan.is_kept():
                plan.prepare(folder)
            stack.enter_context(only_sweep_in(folder))
            write_whole(folder / "multirun.yaml", without_secrets(OmegaConf.to_yaml(self.config), self.config))
            left = plan.leave_out_known()
            if left.repeated:
                print(f"acoexp: {left.repeated} jobs say what others say, and are run once", file=sys.stderr)
            if left.found:
                print(f"acoexp: {left.found} of {left.trials} trials found in the store", file=sys.stderr)
            if not plan.has_reports:
                watched = Watched(
                    folder=folder, where=plan.where, trials=left.trials, known=left.known, found=left.found
                )
                stack.enter_context(watching(watched))
            return self._launch(left.missing, first_number(folder))

    def _launch(self, jobs: list[list[str]], number: int) -> list[Sequence[JobReturn]]:
        """Launch jobs, numbered from a number on; raise if any of them failed."""
        from acoexp.command.sweep.failed import raise_if_failed

        size = self.max_batch_size or max(len(jobs), 1)
        returns = [
            self.launcher.launch(jobs[first : first + size], initial_job_idx=number + first)
            for first in range(0, len(jobs), size)
        ]
        raise_if_failed([job for batch in returns for job in batch])
        return returns
