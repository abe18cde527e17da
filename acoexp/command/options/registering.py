"""Registering: what Hydra offers on the command line, from the parts' declarations and from folders of options."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from hydra.core.config_search_path import ConfigSearchPath, SearchPathQuery
from hydra.core.config_store import ConfigStore
from hydra.core.plugins import Plugins
from hydra.plugins.search_path_plugin import SearchPathPlugin

from acoexp.colony.scalars import ColonySettings
from acoexp.command.options.help import help_text
from acoexp.command.options.keys import JobKeys, ReportKeys
from acoexp.command.options.sources import UserOptions
from acoexp.command.options.tuning import register_tuning
from acoexp.errors import SettingsError, StrategyError
from acoexp.grid.field import FieldSettings
from acoexp.parameters import defaults_of
from acoexp.registry.entries import GROUPS, part_names
from acoexp.registry.folders import plugin_conf_dirs
from acoexp.registry.parts import find_part
from acoexp.tracking.options import TRACKING


def register_options(config_dir: str | None) -> None:
    """Tell Hydra of everything that is declared, and of the user's folder of options.

    Raises:
        SettingsError: if that folder does not exist.
    """
    store = ConfigStore.instance()
    store.store(
        name="settings", node={**_plain(ColonySettings), "field": _plain(FieldSettings), **_plain(JobKeys)}
    )
    for group in GROUPS:
        for name in part_names(group):
            shared = _plain(ReportKeys) if group == "report" else {}
            store.store(group=group, name=name, node={"name": name, **shared, **_parameters(group, name)})
    store.store(group="report", name="none", node={"name": "none"})
    for name, owner in TRACKING.items():
        store.store(group="tracking", name=name, node={"name": name, **_plain(owner)})
    register_tuning()
    store.store(group="hydra/help", name="acoexp", node={"template": help_text()})
    folders = dict(plugin_conf_dirs())
    if config_dir is not None:
        folders = {_existing(config_dir): "command-line", **folders}
    if folders:
        _register_folders(folders)


def _parameters(group: str, name: str) -> dict[str, Any]:
    """Return a part's parameters; none if it is broken, which is said to whoever uses it."""
    try:
        return _plain(find_part(group, name))
    except StrategyError:
        return {}


def _plain(owner: type) -> dict[str, Any]:
    return {n: list(v) if isinstance(v, tuple) else v for n, v in defaults_of(owner).items()}


def _existing(config_dir: str) -> Path:
    folder = Path(config_dir).absolute()
    if not folder.is_dir():
        raise SettingsError(f"--config-dir: expected a folder; got {config_dir!r}")
    return folder


def _register_folders(folders: dict[Path, str]) -> None:
    """Let Hydra look for options in these folders too, in this order, after it has looked in ours."""

    class Folders(SearchPathPlugin):
        def manipulate_search_path(self, search_path: ConfigSearchPath) -> None:
            for folder, provider in folders.items():
                search_path.prepend(provider, f"options://{folder}", SearchPathQuery(provider="schema"))

    Plugins.instance().register(UserOptions)
    Plugins.instance().register(Folders)
