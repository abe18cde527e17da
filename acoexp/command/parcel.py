"""The parcel: what a worker needs of its parent's folder, whichever launcher runs it and on whichever machine.

Maps lie as they were loaded in the sweep's folder; relative addresses travel as absolute ones; and the options are
in memory, so that a worker composes its job without the parent's files.
"""

from __future__ import annotations

import hashlib
import json
import pickle
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager, chdir, nullcontext
from copy import deepcopy
from pathlib import Path, PurePosixPath
from typing import Any

from hydra._internal.core_plugins.file_config_source import FileConfigSource
from hydra.core.config_loader import ConfigLoader
from hydra.core.object_type import ObjectType
from hydra.core.singleton import Singleton
from hydra.plugins.config_source import ConfigLoadError, ConfigResult, ConfigSource

from acoexp import registry
from acoexp.grid import Grid
from acoexp.presets import conf_dir


class Parcel(metaclass=Singleton):
    """One for each process; all of Hydra's launchers take its singletons to their workers.

    Attributes:
        home: The parent's working directory, which a worker on another machine need not have.
        addresses: Absolute addresses of stores, by what the configuration calls them.
        folder: Where the maps of a sweep lie; None outside of sweeps.
    """

    def __init__(self) -> None:
        self.home = Path.cwd()
        self.addresses: dict[str, str] = {}
        self.folder: Path | None = None

    def at_home(self) -> AbstractContextManager[None]:
        """Enter the parent's working directory, if it is there."""
        return chdir(self.home) if self.home.is_dir() else nullcontext()

    def pack(self, sweep: Path, maps: list[tuple[Mapping[str, Any], Grid]]) -> None:
        """Put maps, each with the configuration that it came from, into the folder of a sweep."""
        self.folder = sweep / "maps"
        self.folder.mkdir(parents=True, exist_ok=True)
        for config, grid in maps:
            file = self._file(config)
            draft = file.with_suffix(".draft")
            draft.write_bytes(pickle.dumps(grid))
            draft.replace(file)

    def map_of(self, config: Mapping[str, Any]) -> Path | None:
        """Return the file with the map for a configuration; None if there is none."""
        return self._file(config) if self.folder is not None and self._file(config).is_file() else None

    def _file(self, config: Mapping[str, Any]) -> Path:
        digest = hashlib.sha256(json.dumps(config, sort_keys=True).encode()).hexdigest()[:16]
        return Path(self.folder or "", f"{digest}.pickle")


def carry_options(loader: ConfigLoader) -> None:
    """Let a config loader know all options by heart, wherever it is taken."""
    sources = loader.get_sources()
    sources[:] = [Options(source) if isinstance(source, FileConfigSource) else source for source in sources]


class Options(ConfigSource):
    """A folder of options in memory; a file that was refused is refused when it is asked for."""

    def __init__(self, folder: FileConfigSource) -> None:
        self.provider, self.path = folder.provider, folder.path
        self._results = {name: _read(folder, name) for name in _option_names(Path(folder.path))}
        self._groups = {str(group) for name in self._results for group in PurePosixPath(name).parents}

    @staticmethod
    def scheme() -> str:
        """Return what an address of this kind begins with."""
        return "memory"

    def load_config(self, config_path: str) -> ConfigResult:
        """Return a copy of an option."""
        result = self._results.get(config_path.removesuffix(".yaml"))
        if result is None:
            raise ConfigLoadError(f"Config not found : {config_path}")
        if isinstance(result, Exception):
            raise result
        return deepcopy(result)

    def is_group(self, config_path: str) -> bool:
        """Tell whether there is such a group."""
        return str(PurePosixPath(config_path)) in self._groups

    def is_config(self, config_path: str) -> bool:
        """Tell whether there is such an option."""
        return config_path.removesuffix(".yaml") in self._results

    def available(self) -> bool:
        """Tell that the folder is there, as it is in memory."""
        return True

    def list(self, config_path: str, results_filter: ObjectType | None) -> list[str]:
        """Return the names of the groups and options in a group, sorted."""
        group, found = PurePosixPath(config_path), set[str]()
        if results_filter is not ObjectType.CONFIG:
            found |= {PurePosixPath(name).name for name in self._groups if _is_in(name, group)}
        if results_filter is not ObjectType.GROUP:
            found |= {PurePosixPath(name).name for name in self._results if _is_in(name, group)}
        return sorted(found)


def _is_in(name: str, group: PurePosixPath) -> bool:
    return PurePosixPath(name) != group and PurePosixPath(name).parent == group


def _read(folder: FileConfigSource, name: str) -> ConfigResult | Exception:
    try:
        return folder.load_config(name)
    except Exception as problem:
        return problem


def _option_names(folder: Path) -> Iterator[str]:
    """Yield the names of the options in a folder, which may hold much besides if it is a user's."""
    groups = {*registry.GROUPS, *(path.name for path in conf_dir().iterdir() if path.is_dir())}
    for file in (*folder.glob("*.yaml"), *(f for group in groups for f in (folder / group).rglob("*.yaml"))):
        yield file.relative_to(folder).with_suffix("").as_posix()
