"""One job of a sweep in this process: what Hydra's own ``run_job`` does, in a third of its time.

All that the job, a callback or the sweeper can see is as there: configurations, files, folders, logging and
environment. Copies are made by way of pickles and texts by libyaml; a test holds the two side by side.
"""

from __future__ import annotations

import os
import pickle
from contextlib import chdir, nullcontext
from pathlib import Path
from typing import cast

from hydra.core.hydra_config import HydraConfig
from hydra.core.utils import JobReturn, JobRuntime, JobStatus, _flush_loggers, configure_log, env_override
from hydra.types import HydraContext, TaskFunction
from omegaconf import DictConfig, OmegaConf, open_dict, read_write

from acoexp.command.dumping import yaml_of
from acoexp.command.sweep.secrets import addresses_of


def run_job(context: HydraContext, task: TaskFunction, config: DictConfig) -> JobReturn:
    """Run a job of a sweep in its folder.

    Args:
        context: Hydra's, with the callbacks.
        task: What the job does.
        config: Its configuration, with its number.

    Returns:
        What became of it; an exception is in there.
    """
    before = HydraConfig.instance().cfg
    whole = pickle.dumps(config)  # by which OmegaConf's configurations are copied in a third of the time
    hydra, told = _only_hydra(whole), _only_hydra(whole)
    try:
        _set(config, hydra)
        named = Path(config.hydra.sweep.dir, str(config.hydra.sweep.subdir))
        folder = Path(os.path.abspath(named))  # noqa: PTH100 - as with Hydra, links stay
        for part in (config, hydra, told):
            with read_write(part.hydra.runtime), open_dict(part.hydra.runtime):
                part.hydra.runtime.output_dir = str(folder)
        OmegaConf.set_readonly(told.hydra, True)
        folder.mkdir(parents=True, exist_ok=True)
        with chdir(folder) if config.hydra.job.chdir else nullcontext():
            return _run_here(context, task, config, _without_hydra(whole), told)
    finally:
        HydraConfig.instance().cfg = before


def _run_here(
    context: HydraContext, task: TaskFunction, config: DictConfig, own: DictConfig, hydra: DictConfig
) -> JobReturn:
    job = JobReturn(
        overrides=cast(list[str], OmegaConf.to_container(config.hydra.overrides.task)),
        cfg=own,
        hydra_cfg=hydra,
        working_dir=str(Path.cwd()),
    )
    configure_log(config.hydra.job_logging, config.hydra.verbose)
    _write_down(job, config)
    with env_override(config.hydra.job.env_set):
        context.callbacks.on_job_start(config=config, task_function=task)
        try:
            job.return_value = task(cast(DictConfig, job.cfg))
            job.status = JobStatus.COMPLETED
        except Exception as problem:  # whoever asked for the job decides what it means
            job.return_value = problem
            job.status = JobStatus.FAILED
    job.task_name = JobRuntime.instance().get("name")
    _flush_loggers()
    context.callbacks.on_job_end(config=config, job_return=job)
    return job


def _write_down(job: JobReturn, config: DictConfig) -> None:
    """Write what the job was told, unless that is not wanted; passwords are masked."""
    if config.hydra.output_subdir is None:
        return
    folder = Path(config.hydra.runtime.output_dir, config.hydra.output_subdir)
    folder.mkdir(parents=True, exist_ok=True)
    told = {"config": job.cfg, "hydra": job.hydra_cfg, "overrides": config.hydra.overrides.task}
    addresses = addresses_of(config)
    for name, part in told.items():
        (folder / f"{name}.yaml").write_text(yaml_of(cast(DictConfig, part), *addresses), encoding="utf-8")


def _set(config: DictConfig, hydra: DictConfig) -> None:
    """Let ``HydraConfig`` be of this job; what is not Hydra's in it is hidden, but can be referred to."""
    for part in (config, hydra):
        OmegaConf.set_readonly(part.hydra, True)
    hydra.hydra._set_parent(config)
    HydraConfig.instance().cfg = hydra  # type: ignore[assignment]


def _only_hydra(config: bytes) -> DictConfig:
    copy = cast(DictConfig, pickle.loads(config))
    with open_dict(copy):
        for key in [key for key in copy if key != "hydra"]:
            del copy[key]
    OmegaConf.set_struct(copy, None)
    return copy


def _without_hydra(config: bytes) -> DictConfig:
    copy = cast(DictConfig, pickle.loads(config))
    with read_write(copy), open_dict(copy):
        del copy["hydra"]
    return copy
