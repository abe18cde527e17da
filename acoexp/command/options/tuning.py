"""The keys of ``hydra/sweeper=optuna``: those of the study, and those of each ``hydra/sweeper/sampler``.

Nothing here needs Optuna: Hydra is told of these keys at every command.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hydra.core.config_store import ConfigStore
from hydra.core.plugins import Plugins
from omegaconf import DictConfig, OmegaConf

from acoexp.errors import SettingsError, shown
from acoexp.parameters import build, defaults_of, parameter

MOST_TRIALS = 1_000_000
"""Trials that one command may add to a study, as many as a sweep may have jobs."""
_SWEEPER = "hydra_plugins.acoexp.tuner.OptunaSweeper"
_HIGHEST_SEED = 10**9


@dataclass(frozen=True, kw_only=True)
class TuningKeys:
    """A study, and how many trials of it are run."""

    direction: str = parameter("minimize", "what is best of what jobs return", choices=("minimize", "maximize"))
    storage: str | None = parameter(
        None, "database that keeps the study, such as sqlite:///study.db; kept nowhere if null"
    )
    study_name: str | None = parameter(None, "name by which a later command goes on with it")
    n_trials: int = parameter(20, "trials that this command adds", minimum=1, maximum=MOST_TRIALS)
    n_jobs: int = parameter(2, "how many are chosen and launched together", minimum=1, maximum=MOST_TRIALS)
    max_failure_rate: float = parameter(0.0, "share of n_trials that may fail", minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class Random:
    """Values drawn uniformly."""

    seed: int | None = parameter(
        None, "makes a study repeatable; another one each time if null", minimum=0, maximum=_HIGHEST_SEED
    )


@dataclass(frozen=True, kw_only=True)
class Tpe(Random):
    """Tree-structured Parzen estimator (Bergstra et al. 2011), Optuna's default."""

    n_startup_trials: int = parameter(10, "trials drawn uniformly at first", minimum=0, maximum=MOST_TRIALS)
    n_ei_candidates: int = parameter(24, "candidates for each value", minimum=1, maximum=100_000)
    multivariate: bool | None = parameter(None, "whether keys are looked at together; Optuna's default if null")


@dataclass(frozen=True, kw_only=True)
class CmaEs(Random):
    """Covariance matrix adaptation (Hansen & Ostermeier 2001), for two numbers or more."""

    sigma0: float | None = parameter(
        None, "first step size; a sixth of the narrowest key's width if null", above=0.0
    )


@dataclass(frozen=True, kw_only=True)
class Nsga2(Random):
    """The genetic algorithm NSGA-II (Deb et al. 2002)."""

    population_size: int = parameter(50, "trials of a generation", minimum=2, maximum=MOST_TRIALS)
    mutation_prob: float | None = parameter(
        None, "probability that a value is drawn anew; one in the number of keys if null", minimum=0.0, maximum=1.0
    )
    crossover_prob: float = parameter(0.9, "probability of a crossover", minimum=0.0, maximum=1.0)
    swapping_prob: float = parameter(0.5, "probability that a value is swapped in one", minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class Grid:
    """Every combination once; what a study has of them is left out."""


SAMPLERS: dict[str, type] = {"tpe": Tpe, "random": Random, "cmaes": CmaEs, "nsgaii": Nsga2, "grid": Grid}
"""The options of ``hydra/sweeper/sampler``."""


def register_tuning() -> None:
    """Tell Hydra of the sweeper and its samplers."""
    Plugins.instance()  # finds others' plug-ins, one of which may call a sweeper optuna too: the later one stands
    store = ConfigStore.instance()
    keys = {"_target_": _SWEEPER, "defaults": [{"sampler": "tpe"}], **defaults_of(TuningKeys), "params": None}
    store.store(group="hydra/sweeper", name="optuna", node=keys)
    for name, owner in SAMPLERS.items():
        store.store(group="hydra/sweeper/sampler", name=name, node={"name": name, **defaults_of(owner)})


def read_tuning(config: DictConfig) -> tuple[TuningKeys, dict[str, Any], tuple[str, Any]]:
    """Return the keys of a study, further overrides of its jobs, and its sampler: the name, and the keys.

    Args:
        config: What the configuration has below ``hydra.sweeper``.

    Raises:
        SettingsError: if a key is unknown, or has a wrong value.
    """
    plain: Any = OmegaConf.to_container(config, resolve=True)
    keys = {key: value for key, value in plain.items() if key not in ("_target_", "params", "sampler")}
    params, sampler = plain["params"] or {}, plain["sampler"]
    if not isinstance(params, dict):
        raise SettingsError(f"hydra.sweeper.params: expected keys with values; got {shown(params)}")
    if not isinstance(sampler, dict) or sampler.get("name") not in list(SAMPLERS):
        came = sampler.get("name") if isinstance(sampler, dict) else sampler
        raise SettingsError(f"hydra/sweeper/sampler: expected one of: {', '.join(SAMPLERS)}; got {shown(came)}")
    name = sampler.pop("name")
    chooses = build(SAMPLERS[name], sampler, "hydra.sweeper.sampler.")
    return build(TuningKeys, keys, "hydra.sweeper."), params, (name, chooses)
