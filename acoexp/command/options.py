"""Options: what Hydra offers on the command line, from the parts' declarations and the user's own folder."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hydra._internal.core_plugins.file_config_source import FileConfigSource
from hydra._internal.sources_registry import SourcesRegistry
from hydra.core.config_search_path import ConfigSearchPath, SearchPathQuery
from hydra.core.config_store import ConfigStore
from hydra.core.plugins import Plugins
from hydra.errors import HydraException
from hydra.plugins.config_source import ConfigResult
from hydra.plugins.search_path_plugin import SearchPathPlugin
from omegaconf import OmegaConf
from yaml import YAMLError

from acoexp import registry
from acoexp.colony.problem import ColonySettings
from acoexp.command.help import help_text
from acoexp.errors import SettingsError, StrategyError
from acoexp.field import FieldSettings
from acoexp.parameters import defaults_of
from acoexp.presets import find_preset, plugin_conf_dirs

_RUNS_CODE = re.compile(r"(^|[\s/@.])hydra(?!\w)|_target_")
_OURS = ("config", "settings")


def register_options(config_dir: str | None) -> None:
    """Tell Hydra of every registered part and map, of the scalars, and of the user's folder of options.

    Raises:
        SettingsError: if that folder does not exist.
    """
    store = ConfigStore.instance()
    store.store(name="settings", node={**_plain(ColonySettings), "field": _plain(FieldSettings)})
    for group in registry.GROUPS:
        for name in registry.names(group):
            store.store(group=group, name=name, node={"name": name, **_parameters(group, name)})
    store.store(group="hydra/help", name="acoexp", node={"template": help_text()})
    folders = dict(plugin_conf_dirs())
    if config_dir is not None:
        folders = {_checked(config_dir): "command-line", **folders}
    if folders:
        _register_folders(folders)


def _parameters(group: str, name: str) -> dict[str, Any]:
    """Return a part's parameters; none if it is broken, which is told to whoever uses it."""
    try:
        return _plain(registry.find(group, name))
    except StrategyError:
        return {}


def _plain(owner: type) -> dict[str, Any]:
    return {n: list(v) if isinstance(v, tuple) else v for n, v in defaults_of(owner).items()}


def _checked(config_dir: str) -> Path:
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

    SourcesRegistry.instance().register(UserOptions)
    Plugins.instance().register(Folders)


class UserOptions(FileConfigSource):
    """Option files of a user or of a package: settings of ours, and nothing that makes the program run code."""

    @staticmethod
    def scheme() -> str:
        """Return what an address of this kind begins with."""
        return "options"

    def load_config(self, config_path: str) -> ConfigResult:
        """Read a file and refuse it if it reaches for Hydra's own settings or for code."""
        if config_path in _OURS:
            raise HydraException(
                f"{Path(self.path, config_path)}.yaml: expected options in folders, such as algo/{config_path}; "
                "this name is the program's own"
            )
        folder, name = Path(self.path), Path(config_path).name
        if folder in plugin_conf_dirs() and Path(config_path).parent == Path("algo"):
            find_preset(name)  # refuses it as it does in Python
        try:
            result = super().load_config(config_path)
        except YAMLError as problem:
            reason = " ".join(str(problem).split())
            raise HydraException(f"{Path(folder, config_path)}.yaml: expected YAML; {reason}") from problem
        content = OmegaConf.to_container(result.config, resolve=False)
        where = f"{config_path} {result.header.get('package') or ''}"
        if _RUNS_CODE.search(where) or _reaches_out(content):
            raise HydraException(
                f"{Path(folder, config_path)}.yaml: expected settings of acoexp only; an option file may not "
                "set hydra.* or _target_, which run code"
            )
        return result


def _reaches_out(content: Any, in_defaults: bool = False) -> bool:
    """Tell whether a file's content, or its defaults list, names ``_target_`` or anything of Hydra's."""
    if isinstance(content, dict):
        return any(
            _RUNS_CODE.search(str(key)) or _reaches_out(value, str(key) == "defaults")
            for key, value in content.items()
        )
    if isinstance(content, list):
        return any(_reaches_out(item, in_defaults) for item in content)
    return in_defaults and _RUNS_CODE.search(str(content)) is not None
