"""``hydra/sweeper=optuna``: Optuna chooses what each job is told, by what the jobs before it returned."""

from __future__ import annotations

import sys
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.core.plugins import Plugins
from hydra.core.utils import JobReturn, JobStatus
from hydra.plugins.launcher import Launcher
from hydra.plugins.sweeper import Sweeper
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig, OmegaConf

if TYPE_CHECKING:
    from acoexp.command.options.tuning import TuningKeys
    from acoexp.command.tuning.study import Study

# Its keys are registered by acoexp's command alone (acoexp/command/options/tuning.py): Hydra imports this file in
# every program of this Python, and another may have a hydra/sweeper=optuna of its own.


class OptunaSweeper(Sweeper):
    """Checks the ends of what is chosen from before the first job runs, then runs what a study asks for."""

    def __init__(self, **_: Any) -> None:
        """Take the keys of its configuration, which are checked when the sweep begins."""

    def setup(self, *, hydra_context: HydraContext, task_function: TaskFunction, config: DictConfig) -> None:
        """Take what Hydra gives to every sweeper."""
        self.config: DictConfig = config
        self.loader = hydra_context.config_loader
        self.launcher: Launcher = Plugins.instance().instantiate_launcher(
            hydra_context=hydra_context, task_function=task_function, config=config
        )

    def sweep(self, arguments: list[str]) -> list[JobReturn]:
        """Add trials to a study, a new one or one that is there; return what their jobs returned."""
        from acoexp.command.options.tuning import read_tuning  # Hydra imports this file at every command
        from acoexp.command.results.watch import Watched, watching
        from acoexp.command.sweep.plan import first_number, fix_folder, only_sweep_in
        from acoexp.command.sweep.secrets import without_secrets
        from acoexp.command.tuning.checking import check_installed, checked_plan
        from acoexp.command.tuning.space import Space
        from acoexp.command.tuning.study import Study
        from acoexp.console.whole import write_whole

        check_installed()
        keys, params, sampler = read_tuning(self.config.hydra.sweeper)
        texts = [*(f"{key}={value}" for key, value in params.items()), *arguments]
        space = Space(OverridesParser.create(config_loader=self.loader).parse_overrides(texts))
        plan = checked_plan(self.config, self.loader, space, keys.storage)
        folder = fix_folder(self.config)
        study = Study(keys, sampler, space)
        plan.prepare(folder)
        with ExitStack() as stack:
            stack.enter_context(only_sweep_in(folder))
            write_whole(folder / "multirun.yaml", without_secrets(OmegaConf.to_yaml(self.config), self.config))
            if study.trials_before:
                print(f"acoexp: study {study.name} goes on after {study.trials_before} trials", file=sys.stderr)
            wanted = study.left(keys.n_trials)
            of_a_job = {job.trials for job in plan.jobs.values()}
            trials = wanted * of_a_job.pop() if len(of_a_job) == 1 else None
            stack.enter_context(watching(Watched(folder=folder, where=plan.where, trials=trials)))
            return self._run(study, keys, folder, wanted, first_number(folder))

    def _run(self, study: Study, keys: TuningKeys, folder: Path, wanted: int, number: int) -> list[JobReturn]:
        """Run trials, some at once, until all are run or too many failed; jobs are numbered from a number on."""
        from acoexp.command.sweep.failed import print_failed, raise_if_failed

        jobs: list[JobReturn] = []
        too_many = False
        while not too_many and (left := study.left(wanted - len(jobs))):
            jobs += self._launch(study, min(keys.n_jobs, left), number + len(jobs))
            study.write_best(folder / "optimization_results.yaml")
            failed = sum(job.status != JobStatus.COMPLETED for job in jobs)
            too_many = failed / keys.n_trials > keys.max_failure_rate
        (raise_if_failed if too_many else print_failed)(jobs)
        return jobs

    def _launch(self, study: Study, size: int, number: int) -> list[JobReturn]:
        """Run some trials at once and tell the study what came of them, or that they were given up."""
        from acoexp.errors import AcoexpError

        chosen = []
        try:
            for _ in range(size):
                chosen.append(study.ask())
            told = [study.space.told(trial.values) for trial in chosen]
            jobs: list[JobReturn] = [*self.launcher.launch(told, initial_job_idx=number)]
        except BaseException:
            with suppress(AcoexpError):
                for trial in chosen:
                    study.tell(trial, None)
            raise
        for trial, job in zip(chosen, jobs, strict=True):
            study.tell(trial, float(job.return_value) if job.status == JobStatus.COMPLETED else None)
        return jobs
