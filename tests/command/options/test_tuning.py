"""The keys of a study: declared here, known to Hydra, and each refused by its name."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hydra.core.config_store import ConfigStore
from omegaconf import DictConfig, OmegaConf

from acoexp.command.options.tuning import SAMPLERS, Random, Tpe, TuningKeys, read_tuning, register_tuning
from acoexp.errors import SettingsError

Composed = Callable[..., DictConfig]


def test_without_a_word_the_keys_are_as_declared(composed: Composed) -> None:
    sweeper = composed("hydra/sweeper=optuna").hydra.sweeper
    assert read_tuning(sweeper) == (TuningKeys(), {}, ("tpe", Tpe()))


@pytest.mark.parametrize("name", SAMPLERS)
def test_each_sampler_is_an_option_with_its_keys(name: str, composed: Composed) -> None:
    sweeper = composed("hydra/sweeper=optuna", f"hydra/sweeper/sampler={name}").hydra.sweeper
    assert read_tuning(sweeper)[2] == (name, SAMPLERS[name]())


def test_what_is_said_on_the_command_line_counts(composed: Composed) -> None:
    said = ["hydra/sweeper/sampler=random", "hydra.sweeper.sampler.seed=1", "hydra.sweeper.n_trials=7"]
    sweeper = composed("hydra/sweeper=optuna", *said, "hydra.sweeper.params={rho: '0.1'}").hydra.sweeper
    assert read_tuning(sweeper) == (TuningKeys(n_trials=7), {"rho": "0.1"}, ("random", Random(seed=1)))


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("direction", "up", "hydra.sweeper.direction: expected one of: minimize, maximize; got 'up'"),
        ("n_trials", 0, "hydra.sweeper.n_trials: expected a whole number from 1 to 1000000; got 0"),
        ("n_trials", -1, "hydra.sweeper.n_trials: expected a whole number from 1 to 1000000; got -1"),
        ("n_trials", 10**30, f"hydra.sweeper.n_trials: expected a whole number from 1 to 1000000; got {10**30}"),
        ("n_jobs", True, "hydra.sweeper.n_jobs: expected a whole number from 1 to 1000000; got True"),
        ("max_failure_rate", 1.5, "hydra.sweeper.max_failure_rate: expected a number from 0 to 1; got 1.5"),
        ("storage", 7, "hydra.sweeper.storage: expected a text; got 7"),
        ("params", 7, "hydra.sweeper.params: expected keys with values; got 7"),
        ("sampler", "tpe", "hydra/sweeper/sampler: expected one of: tpe, random, cmaes, nsgaii, grid; got 'tpe'"),
        ("sampler.name", [], "hydra/sweeper/sampler: expected one of: tpe, random, cmaes, nsgaii, grid; got []"),
        ("sampler.seed", -1, "hydra.sweeper.sampler.seed: expected a whole number from 0 to 1e+09; got -1"),
        ("sampler.sed", 1, "hydra.sweeper.sampler.sed is not a known key; "),
        ("trials", 1, "hydra.sweeper.trials is not a known key; "),
    ],
)
def test_a_key_that_is_wrong_is_refused_by_its_name(
    key: str, value: object, said: str, composed: Composed
) -> None:
    sweeper = OmegaConf.create(OmegaConf.to_container(composed("hydra/sweeper=optuna").hydra.sweeper))
    OmegaConf.update(sweeper, key, value)
    with pytest.raises(SettingsError) as caught:
        read_tuning(sweeper)
    assert str(caught.value).startswith(said)


def test_a_sweeper_of_the_same_name_that_is_installed_gives_way(hydra: None) -> None:
    store = ConfigStore.instance()
    store.store(group="hydra/sweeper", name="optuna", node={"_target_": "others"})
    register_tuning()
    node = store.load("hydra/sweeper/optuna.yaml").node
    assert node["_target_"] == "hydra_plugins.acoexp.tuner.OptunaSweeper"
