"""Where Hydra reads options from: folders of a user's or a package's own, checked, and what workers remember."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path
from typing import Any

from hydra.core.config_loader import ConfigLoader
from hydra.core.object_type import ObjectType
from hydra.errors import HydraException
from hydra.plugins.config_source import ConfigLoadError, ConfigResult, ConfigSource
from omegaconf import OmegaConf
from yaml import YAMLError

from acoexp.command.options.trust import check_option
from acoexp.console.bounded import check_bounded
from acoexp.registry.folders import plugin_conf_dirs
from acoexp.registry.presets import find_preset

_OURS = ("config", "settings")
_LARGEST = 2**20
"""Bytes that an option file may have."""
_MOST_VALUES = 100_000
"""Values that it may have."""


class UserOptions(ConfigSource):
    """A folder with option files: settings of ours, and nothing that makes the program run code."""

    def __init__(self, provider: str, path: str) -> None:
        super().__init__(provider=provider, path=path)
        self._folder = Path(self.path)

    @staticmethod
    def scheme() -> str:
        """Return what an address of this kind begins with."""
        return "options"

    def load_config(self, config_path: str) -> ConfigResult:
        """Read a file and refuse it if it reaches for Hydra's own settings or for code."""
        if config_path in _OURS:
            raise HydraException(
                f"{self._folder / config_path}.yaml: expected options in folders, such as algo/{config_path}; "
                "this name is the program's own"
            )
        if self._folder in plugin_conf_dirs() and Path(config_path).parent == Path("algo"):
            find_preset(Path(config_path).name)  # refuses it as it does in Python
        result = self._read(self._folder / self._normalize_file_name(config_path))
        check_option(
            str(self._folder / self._normalize_file_name(config_path)),
            config_path,
            result.header.get("package") or "",
            OmegaConf.to_container(result.config, resolve=False),
        )
        return result

    def _read(self, file: Path) -> ConfigResult:
        if not file.is_file():
            raise ConfigLoadError(f"Config not found : {file}")
        if not file.resolve().is_relative_to(self._folder.resolve()):
            raise HydraException(f"{file}: expected a file of this folder; got a link that leads out of it")
        try:
            text = read_bounded(file)
            header = self._get_header_dict(text[:512])
            return ConfigResult(
                provider=self.provider, path=self.full_path(), config=OmegaConf.create(text), header=header
            )
        except (YAMLError, ValueError, RecursionError) as problem:
            raise HydraException(f"{file}: expected YAML; {' '.join(str(problem).split())}") from problem

    def is_group(self, config_path: str) -> bool:
        """Tell whether there is such a folder."""
        return (self._folder / config_path).is_dir()

    def is_config(self, config_path: str) -> bool:
        """Tell whether there is such a file."""
        return (self._folder / self._normalize_file_name(config_path)).is_file()

    def available(self) -> bool:
        """Tell whether the folder is there."""
        return self._folder.is_dir()

    def list(self, config_path: str, results_filter: ObjectType | None) -> list[str]:
        """Return the names of what a folder has, sorted."""
        found: list[str] = []
        for file in (self._folder / config_path).iterdir():
            self._list_add_result(found, str(Path(config_path, file.name)), file.name, results_filter)
        return sorted(set(found))


def read_bounded(file: Path) -> str:
    """Return the text of an option file that is no larger than one can be, also with its aliases written out.

    Raises:
        ValueError: if it is larger, contains itself, or is no text.
    """
    with file.open("rb") as opened:
        content = opened.read(_LARGEST + 1)
    if len(content) > _LARGEST:
        raise ValueError(f"it has more than {_LARGEST // 2**20} MiB")
    text = content.decode("utf-8")
    check_bounded(text, _MOST_VALUES)
    return text


def remember_options(loader: ConfigLoader) -> None:
    """Let a config loader remember from now on what it reads from folders, and take it along to workers."""
    sources = loader.get_sources()
    folders = ("file", UserOptions.scheme())
    sources[:] = [Remembered(source) if source.scheme() in folders else source for source in sources]


class Remembered(ConfigSource):
    """A folder of options that is asked for each thing once; for what was asked, nobody needs the folder."""

    def __init__(self, folder: ConfigSource) -> None:
        self.provider, self.path = folder.provider, folder.path
        self._folder = folder
        self._answers: dict[tuple[Any, ...], Any] = {}

    def __deepcopy__(self, _: Any) -> Remembered:
        """Return itself: Hydra composes each job from a copy of its sources, whose memory would be lost."""
        return self

    @staticmethod
    def scheme() -> str:
        """Return what the address of a folder begins with."""
        return "file"

    def load_config(self, config_path: str) -> ConfigResult:
        """Return an option."""
        result: ConfigResult = self._ask("load_config", config_path)
        return result

    def is_group(self, config_path: str) -> bool:
        """Tell whether there is such a group."""
        return bool(self._ask("is_group", config_path))

    def is_config(self, config_path: str) -> bool:
        """Tell whether there is such an option."""
        return bool(self._ask("is_config", config_path))

    def available(self) -> bool:
        """Tell whether the folder is, or was, there."""
        return bool(self._ask("available"))

    def list(self, config_path: str, results_filter: ObjectType | None) -> list[str]:
        """Return the names of what a group has."""
        return [*self._ask("list", config_path, results_filter)]

    def _ask(self, *question: Any) -> Any:
        if question not in self._answers:
            method, *arguments = question
            self._answers[question] = getattr(self._folder, method)(*arguments)
        return deepcopy(self._answers[question])
