"""What is declared in code, as Hydra gets it: each part an option of its group, made when it is asked for."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest
from hydra.core.object_type import ObjectType
from hydra.plugins.config_source import ConfigLoadError
from omegaconf import OmegaConf

from acoexp.command.options import declared
from acoexp.command.options.declared import Declared
from acoexp.errors import StrategyError
from acoexp.parameters import defaults_of
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.parts import find_part
from acoexp.tracking.options import TRACKING

SOURCE = Declared("acoexp", "declared://")


def option(group: str, name: str) -> Any:
    """Return an option as Hydra gets it."""
    return OmegaConf.to_container(SOURCE.load_config(f"{group}/{name}.yaml").config)


@pytest.mark.parametrize("group", GROUPS)
def test_each_part_is_an_option_with_its_parameters_and_their_defaults(group: str) -> None:
    for name in part_names(group):
        defaults = defaults_of(find_part(group, name))
        plain = {key: list(value) if isinstance(value, tuple) else value for key, value in defaults.items()}
        shared = {"folder": None} if group == "report" else {}
        assert option(group, name) == {"name": name, **shared, **plain}


def test_there_may_be_no_report_and_no_tracking() -> None:
    assert option("report", "none") == {"name": "none"}
    assert option("tracking", "none") == {"name": "none"}
    assert option("tracking", "mlflow") == {"name": "mlflow", **defaults_of(TRACKING["mlflow"])}


def test_a_broken_part_is_offered_without_parameters_and_harms_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    def find(group: str, name: str, real: Any = find_part) -> Any:
        if name == "luo_wu":
            raise StrategyError("luo_wu cannot be imported")
        return real(group, name)

    with monkeypatch.context() as broken:
        broken.setattr(declared, "find_part", find)
        assert option("diffusion", "luo_wu") == {"name": "luo_wu"}
        assert "gamma" in option("diffusion", "gaussian")
    assert "gamma" in option("diffusion", "luo_wu")


def test_it_lists_what_there_is() -> None:
    assert SOURCE.list("", ObjectType.CONFIG) == ["settings"]
    assert SOURCE.list("", ObjectType.GROUP) == sorted([*GROUPS, "tracking"])
    assert SOURCE.list("diffusion", None) == part_names("diffusion")
    assert SOURCE.list("diffusion", ObjectType.GROUP) == SOURCE.list("nothing", None) == []
    assert [SOURCE.is_group(name) for name in ("map", "map/fig13", "nothing")] == [True, False, False]
    assert [SOURCE.is_config(name) for name in ("map/fig13", "map/fig13.yaml", "map")] == [True, True, False]
    with pytest.raises(ConfigLoadError, match="map/nowhere"):
        SOURCE.load_config("map/nowhere")


def test_what_one_does_with_an_option_nobody_else_sees() -> None:
    SOURCE.load_config("settings").config.rho = 0.25
    assert SOURCE.load_config("settings").config.rho == 0.5
    assert deepcopy(SOURCE) is SOURCE
