"""What is declared in code, as Hydra gets it: by groups; a part's package is imported when the part is chosen."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from hydra.core.object_type import ObjectType
from hydra.plugins.config_source import ConfigLoadError, ConfigResult, ConfigSource
from omegaconf import OmegaConf

from acoexp.colony.scalars import ColonySettings
from acoexp.command.options.keys import JobKeys, ReportKeys
from acoexp.errors import StrategyError
from acoexp.grid.field import FieldSettings
from acoexp.parameters import defaults_of
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.parts import find_part
from acoexp.tracking.options import TRACKING


class Declared(ConfigSource):
    """All options that no file holds, each made when it is asked for."""

    def __deepcopy__(self, _: Any) -> Declared:
        """Return itself: Hydra copies its sources again and again, and this one never changes."""
        return self

    @staticmethod
    def scheme() -> str:
        """Return what the address of such options begins with."""
        return "declared"

    def load_config(self, config_path: str) -> ConfigResult:
        """Return an option.

        Raises:
            ConfigLoadError: if there is no such.
        """
        make = _options().get(_plain(config_path))
        if make is None:
            raise ConfigLoadError(f"Config not found : {config_path}")
        return ConfigResult(
            provider=self.provider,
            path=self.full_path(),
            config=OmegaConf.create(make()),
            header={"package": None},
        )

    def is_group(self, config_path: str) -> bool:
        """Tell whether there is such a group."""
        return any(option.startswith(f"{_plain(config_path)}/") for option in _options())

    def is_config(self, config_path: str) -> bool:
        """Tell whether there is such an option."""
        return _plain(config_path) in _options()

    def available(self) -> bool:
        """Tell that they are there."""
        return True

    def list(self, config_path: str, results_filter: ObjectType | None) -> list[str]:
        """Return the names of what a group has, sorted."""
        group = _plain(config_path)
        inner = [
            option.removeprefix(f"{group}/")
            for option in _options()
            if not group or option.startswith(f"{group}/")
        ]
        found: list[str] = []
        for name in {option.partition("/")[0] for option in inner}:
            self._list_add_result(found, f"{group}/{name}", name, results_filter)
        return sorted(found)


def _plain(config_path: str) -> str:
    return config_path.strip("/").removesuffix(".yaml")


def _options() -> dict[str, Callable[[], dict[str, Any]]]:
    """Return what makes each option, by its group and name."""
    parts = {f"{group}/{name}": partial(_part, group, name) for group in GROUPS for name in part_names(group)}
    tracking = {f"tracking/{name}": partial(_of, owner, name=name) for name, owner in TRACKING.items()}
    return {
        "settings": _settings,
        **parts,
        "report/none": lambda: {"name": "none"},
        **tracking,
    }


def _settings() -> dict[str, Any]:
    return {**_of(ColonySettings), "field": _of(FieldSettings), **_of(JobKeys)}


def _part(group: str, name: str) -> dict[str, Any]:
    """Return a part's parameters; none if it is broken, which is said to whoever uses it."""
    shared = _of(ReportKeys) if group == "report" else {}
    try:
        return {"name": name, **shared, **_of(find_part(group, name))}
    except StrategyError:
        return {"name": name, **shared}


def _of(owner: type, **first: str) -> dict[str, Any]:
    return {**first, **{n: list(v) if isinstance(v, tuple) else v for n, v in defaults_of(owner).items()}}
