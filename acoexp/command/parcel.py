"""The parcel: what a worker needs from its parent, whichever launcher runs it and on whichever machine.

Maps lie as they were loaded in the sweep's folder; relative addresses travel as absolute ones; and the options
that the parent has read are in memory, so that a worker composes its job without the parent's files.
"""

from __future__ import annotations

import hashlib
import json
import pickle
from collections.abc import Mapping
from contextlib import AbstractContextManager, chdir, nullcontext
from copy import deepcopy
from pathlib import Path
from typing import Any

from hydra._internal.core_plugins.file_config_source import FileConfigSource
from hydra.core.config_loader import ConfigLoader
from hydra.core.object_type import ObjectType
from hydra.core.singleton import Singleton
from hydra.plugins.config_source import ConfigResult, ConfigSource

from acoexp.grid import Grid


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
        digest = hashlib.sha256(json.dumps(config, sort_keys=True, default=str).encode()).hexdigest()[:16]
        return Path(self.folder or "", f"{digest}.pickle")


def carry_options(loader: ConfigLoader) -> None:
    """Let a config loader remember from now on what it reads from folders, and take it along."""
    sources = loader.get_sources()
    sources[:] = [Remembered(source) if isinstance(source, FileConfigSource) else source for source in sources]


class Remembered(ConfigSource):
    """A folder of options that is asked for each thing once; for what was asked, nobody needs the folder."""

    def __init__(self, folder: FileConfigSource) -> None:
        self.provider, self.path = folder.provider, folder.path
        self._folder = folder
        self._answers: dict[tuple[Any, ...], Any] = {}

    def __deepcopy__(self, _: Any) -> Remembered:
        """Return itself: Hydra composes each job from a copy of its sources, whose memory would be lost."""
        return self

    @staticmethod
    def scheme() -> str:
        """Return what an address of this kind begins with."""
        return FileConfigSource.scheme()

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
