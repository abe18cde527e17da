"""A series: jobs of a sweep that differ by their seed alone, of which Hydra composes the first and the last.

What lies between is the first one's configuration with the seed in its three places. That the last one, made that
way, is what Hydra composes shows that nothing else depends on the seed; otherwise Hydra composes each.
"""

from __future__ import annotations

import pickle
import re
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import cast

from hydra.core.config_loader import ConfigLoader
from omegaconf import DictConfig, OmegaConf, open_dict

from acoexp.command.sweep.told import as_written

_SEED = re.compile("seed=(0|[1-9][0-9]{0,18})")
"""What a job is told of its seed, where nothing but a number can be meant."""


def composed(loader: ConfigLoader, config: DictConfig, jobs: Sequence[Sequence[str]]) -> Iterator[DictConfig]:
    """Yield the configuration of each job of a sweep, as Hydra composes it.

    Args:
        loader: Composes a configuration.
        config: The sweep's configuration.
        jobs: The overrides of each job.
    """
    for _, same in groupby(jobs, _but_seed):
        overrides = [list(job) for job in same]
        first = loader.load_sweep_config(config, overrides[0])
        template = pickle.dumps(first)  # before a job does anything to it
        yield first
        alike = len(overrides) > 2 and _is_alike(loader, config, template, overrides[0], overrides[-1])
        for job in overrides[1:]:
            yield _reseeded(template, overrides[0], job) if alike else loader.load_sweep_config(config, job)


def _is_alike(
    loader: ConfigLoader, config: DictConfig, template: bytes, first: list[str], last: list[str]
) -> bool:
    """Tell whether a job's configuration is that of another with its own seed."""
    if not any(map(_SEED.fullmatch, first)) or not any(map(_SEED.fullmatch, last)):
        return False
    made, wanted = (
        OmegaConf.to_container(one, resolve=False)
        for one in (_reseeded(template, first, last), loader.load_sweep_config(config, last))
    )
    return made == wanted


def _reseeded(template: bytes, first: list[str], job: list[str]) -> DictConfig:
    """Return the configuration of a job, given that of the first one of its series, pickled.

    A pickle is read in a fifth of the time in which OmegaConf copies what it holds.
    """
    old, new = (next(text for text in overrides if _SEED.fullmatch(text)) for overrides in (first, job))
    config = cast(DictConfig, pickle.loads(template))
    about = config.hydra
    with open_dict(config):
        config.seed = int(new.partition("=")[2])
        told = [new if text == old else text for text in as_written(about.overrides.task)]
        about.overrides.task = told
        signs = about.job.config.override_dirname
        named = [text for text in told if _key(text) not in signs.exclude_keys]
        about.job.override_dirname = signs.item_sep.join(sorted(named)).replace("=", signs.kv_sep)
    return config


def _key(override: str) -> str:
    return override.lstrip("+~").partition("=")[0]


def _but_seed(overrides: Sequence[str]) -> tuple[str, ...]:
    """Return what a job is told, with a blank for the seed's number."""
    return tuple("seed=" if _SEED.fullmatch(text) else text for text in overrides)
