"""What each job of a sweep is told, and the configuration that Hydra composes of it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import product
from typing import cast

from hydra.core.config_loader import ConfigLoader
from hydra.core.override_parser.types import Override
from hydra.errors import HydraException
from hydra.types import RunMode
from omegaconf import DictConfig, ListConfig, OmegaConf

from acoexp.trial.seeds import check_seed

Overrides = list[str]
"""What one job is told, each ``key=value``."""


def combinations(overrides: Iterable[Override]) -> list[Overrides]:
    """Return what each job of a sweep is told: one of the values of each key, the last key's changing fastest.

    Raises:
        HydraException: for a sweep that only an optimiser can choose from, such as ``interval(0, 1)``.
    """
    values: dict[str, list[str]] = {}
    for override in overrides:
        key = override.get_key_element()
        values[key] = [f"{key}={value}" for value in values_of(override)]
    return [list(combination) for combination in product(*values.values())]


def as_written(overrides: ListConfig) -> list[str]:
    """Return overrides with what they refer to, such as ``${hydra.job.num}``, which only a job knows."""
    return cast(list[str], OmegaConf.to_container(overrides, resolve=False))


def composed(loader: ConfigLoader, overrides: Overrides) -> DictConfig:
    """Return the configuration of a job; what its folder's name refers to must be in it.

    Raises:
        OmegaConfBaseException, HydraException: if something is not.
    """
    config = loader.load_configuration("config", overrides, run_mode=RunMode.RUN)
    if not OmegaConf.is_missing(config.hydra.sweep, "subdir"):
        numbered = OmegaConf.merge(config, {"hydra": {"job": {"num": 0, "id": "0"}}})
        _ = numbered.hydra.sweep.subdir
    return config


def has_references(config: DictConfig) -> bool:
    """Tell whether anything in a configuration refers to something else, such as ``map.seed=${seed}``."""
    ours = OmegaConf.masked_copy(config, [str(key) for key in config if key != "hydra"])
    return "${" in str(OmegaConf.to_container(ours, resolve=False))


def is_seed(text: str) -> bool:
    """Tell whether it is the seed that a job is told by a text."""
    return text.lstrip("+").partition("=")[0] == "seed"


def check_seeds(override: Override) -> None:
    """Refuse seeds that are none.

    Raises:
        SettingsError: for the first of them.
    """
    for text in values_of(override):
        check_seed(int(text) if re.fullmatch("0|[1-9][0-9]*", text) else text)


def values_of(override: Override) -> list[str]:
    """Return the values of a key, each as it is written.

    Raises:
        HydraException: for what only an optimiser can choose from.
    """
    if not override.is_sweep_override():
        return [override.get_value_element_as_str()]
    if override.is_discrete_sweep():
        return list(override.sweep_string_iterator())
    raise HydraException(
        f"{override.input_line}: expected values or a range, such as 0.1,0.2 or range(0,9); only another "
        "hydra/sweeper, such as optuna, chooses from an interval"
    )
