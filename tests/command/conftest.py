"""Hydra within this process: its configurations, and a handover that no other test has used."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from hydra import compose, initialize_config_dir
from hydra.core.hydra_config import HydraConfig
from hydra.core.singleton import Singleton
from hydra.types import RunMode
from omegaconf import DictConfig, open_dict

from acoexp.command.handover import Handover
from acoexp.command.options.registering import register_options
from acoexp.registry.folders import conf_dir


@pytest.fixture(scope="session")
def hydra() -> Iterator[None]:
    """Start Hydra as the command does, with all options registered."""
    register_options(None)
    with initialize_config_dir(str(conf_dir()), version_base="1.3"):
        yield


@pytest.fixture
def composed(hydra: None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., DictConfig]:
    """Return what composes the configuration of a job from overrides; its folder is ``job`` in an empty one."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(Singleton._instances, HydraConfig, HydraConfig())

    def compose_job(*overrides: str, mode: RunMode = RunMode.RUN) -> DictConfig:
        config = compose("config", list(overrides), return_hydra_config=True)
        folder = tmp_path / "job"
        folder.mkdir(exist_ok=True)
        with open_dict(config):
            config.hydra.runtime.output_dir = str(folder)
            config.hydra.run.dir = "job"
            config.hydra.mode = mode
        HydraConfig.instance().set_config(config)
        return config

    return compose_job


@pytest.fixture
def handover(monkeypatch: pytest.MonkeyPatch) -> Handover:
    """Return this process's handover, a new one for each test."""
    monkeypatch.delitem(Singleton._instances, Handover, raising=False)
    return Handover()
