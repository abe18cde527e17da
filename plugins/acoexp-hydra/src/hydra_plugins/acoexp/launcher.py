"""``hydra/launcher=acoexp``, that of ``engine=basic``: one job after the other, in the command's own process."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from pathlib import Path

from hydra.core.config_store import ConfigStore
from hydra.core.utils import JobReturn, configure_log, filter_overrides, setup_globals
from hydra.plugins.launcher import Launcher
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig, open_dict

log = logging.getLogger(__name__)

ConfigStore.instance().store(
    group="hydra/launcher",
    name="acoexp",
    node={"_target_": "hydra_plugins.acoexp.launcher.AcoexpLauncher"},
    provider="acoexp",
)


class AcoexpLauncher(Launcher):
    """Does what Hydra's basic launcher does; jobs that differ by their seed alone are not composed one by one."""

    def setup(self, *, hydra_context: HydraContext, task_function: TaskFunction, config: DictConfig) -> None:
        """Take what Hydra gives to every launcher."""
        self.context = hydra_context
        self.task = task_function
        self.config: DictConfig = config

    def launch(self, job_overrides: Sequence[Sequence[str]], initial_job_idx: int) -> Sequence[JobReturn]:
        """Run jobs, numbered from a number on; return what became of them."""
        from acoexp.command.sweep.running import run_job  # Hydra imports this file at every command
        from acoexp.command.sweep.series import composed
        from acoexp.console.collecting import set_aside

        setup_globals()
        configure_log(self.config.hydra.hydra_logging, self.config.hydra.verbose)
        Path(self.config.hydra.sweep.dir).mkdir(parents=True, exist_ok=True)
        log.info(f"Launching {len(job_overrides)} jobs locally")
        # where nothing is said between jobs, there is nothing to be made ready for that
        tells, last = log.isEnabledFor(logging.INFO), initial_job_idx + len(job_overrides) - 1
        jobs: list[JobReturn] = []
        configs = composed(self.context.config_loader, self.config, job_overrides)
        for number, overrides in enumerate(job_overrides, initial_job_idx):
            if tells:
                log.info(f"\t#{number} : {' '.join(filter_overrides(overrides))}")
            config = next(configs)
            with open_dict(config):
                config.hydra.job.id = config.hydra.job.num = number
            jobs.append(run_job(self.context, self.task, config))
            set_aside()  # Hydra wants to know what became of each job: that grows, and stays
            if tells or number == last:
                configure_log(self.config.hydra.hydra_logging, self.config.hydra.verbose)
        return jobs
