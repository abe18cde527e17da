"""Jobs that differ by their seed alone: each has the configuration that Hydra would compose of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
from hydra.core.config_loader import ConfigLoader
from hydra.core.global_hydra import GlobalHydra
from omegaconf import DictConfig, OmegaConf

from acoexp.command.sweep.series import composed

CALLS = "load_sweep_config"


class Counting:
    """A loader of Hydra's that counts what it composes."""

    def __init__(self, loader: ConfigLoader) -> None:
        self._loader, self.calls = loader, 0

    def load_sweep_config(self, config: DictConfig, overrides: list[str]) -> DictConfig:
        self.calls += 1
        return self._loader.load_sweep_config(config, overrides)


@pytest.fixture
def loader(hydra: None) -> Counting:
    return Counting(GlobalHydra.instance().config_loader())


@pytest.fixture
def sweep(composed: Callable[..., DictConfig]) -> DictConfig:
    return composed("hydra.job.config.override_dirname.item_sep=+")


def seeds(*others: str, of: Sequence[int] = range(5, 11)) -> list[list[str]]:
    return [["algo=aco", *others, f"seed={seed}", "rho=0.2"] for seed in of]


@pytest.mark.parametrize(
    ("jobs", "calls"),
    [
        (seeds(), 2),
        (seeds("map=random", "map.seed=${seed}"), 2),
        (seeds("map=random", "map.seed=5"), 2),
        (seeds() + seeds("ants=3"), 4),
        (seeds(of=[1, 2]), 2),
        ([["algo=aco"], ["algo=aco"], ["algo=aco"]], 3),
        (seeds("hydra.job.config.override_dirname.exclude_keys=[seed]"), 2),
        (seeds("+hydra.job.env_set.X=${seed}"), 2),
        ([["seed=1"], ["seed='2'"], ["seed=3"]], 3),
    ],
)
def test_each_is_what_hydra_composes(
    jobs: list[list[str]], calls: int, loader: Counting, sweep: DictConfig
) -> None:
    made = list(composed(loader, sweep, jobs))  # type: ignore[arg-type]
    assert loader.calls == calls
    for config, job in zip(made, jobs, strict=True):
        assert said(config) == said(loader.load_sweep_config(sweep, job))


def said(config: DictConfig) -> tuple[Any, ...]:
    flags = [config._get_flag(name) for name in ("struct", "readonly")]
    return OmegaConf.to_container(config, resolve=False), OmegaConf.get_type(config.hydra), flags


def test_what_a_job_does_to_its_configuration_is_its_own(loader: Counting, sweep: DictConfig) -> None:
    configs = composed(loader, sweep, seeds())  # type: ignore[arg-type]
    first, second = next(configs), next(configs)
    first.rho = second.rho = 0.9
    assert [config.rho for config in configs] == [0.2] * 4


def test_where_the_seed_is_more_than_a_number_each_is_composed(
    loader: Counting, sweep: DictConfig, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    real = Counting.load_sweep_config

    def odd(self: Counting, config: DictConfig, overrides: list[str]) -> DictConfig:
        made = real(self, config, overrides)
        made.ants = 5 + made.seed % 2
        return made

    monkeypatch.setattr(Counting, CALLS, odd)
    made = list(composed(loader, sweep, seeds(of=range(4))))  # type: ignore[arg-type]
    assert [config.ants for config in made] == [5, 6, 5, 6]
