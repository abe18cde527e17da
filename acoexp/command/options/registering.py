"""Registering: what Hydra offers on the command line, from the parts' declarations and from folders of options."""

from __future__ import annotations

from pathlib import Path

from hydra.core.config_search_path import ConfigSearchPath, SearchPathQuery
from hydra.core.config_store import ConfigStore
from hydra.core.plugins import Plugins
from hydra.plugins.search_path_plugin import SearchPathPlugin

from acoexp.command.options.declared import Declared
from acoexp.command.options.help import help_text
from acoexp.command.options.sources import UserOptions
from acoexp.command.options.tuning import register_tuning
from acoexp.errors import SettingsError
from acoexp.registry.folders import plugin_conf_dirs

_NO_HELP = "python -m acoexp --help lists every option\n"


def register_options(config_dir: str | None, *, with_help: bool = False) -> None:
    """Tell Hydra of everything that is declared, and of the user's folder of options.

    Args:
        config_dir: That folder, if there is one.
        with_help: Whether it is asked for the help, for which every part is loaded.

    Raises:
        SettingsError: if that folder does not exist.
    """
    Plugins.instance().register(Declared)
    Plugins.instance().register(_Declared)
    help_of = {"template": help_text() if with_help else _NO_HELP}
    ConfigStore.instance().store(group="hydra/help", name="acoexp", node=help_of)
    register_tuning()
    folders = dict(plugin_conf_dirs())
    if config_dir is not None:
        folders = {_existing(config_dir): "command-line", **folders}
    if folders:
        _register_folders(folders)


class _Declared(SearchPathPlugin):
    """Lets Hydra look for options among what is declared, after it has looked in all folders."""

    def manipulate_search_path(self, search_path: ConfigSearchPath) -> None:
        search_path.append("acoexp", f"{Declared.scheme()}://")


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
