"""The handover: what a worker needs from its parent, whichever launcher runs it and on whichever machine.

Maps lie as they were loaded in the sweep's folder; relative addresses travel as absolute ones; and the options
that the parent has read are in memory, so that a worker composes its job without the parent's files.
"""

from __future__ import annotations

import hashlib
import json
import pickle
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, chdir, nullcontext
from functools import lru_cache
from pathlib import Path
from typing import Any

from hydra.core.singleton import Singleton

from acoexp.console.whole import write_whole
from acoexp.grid.grid import Grid


class Handover(metaclass=Singleton):
    """One for each process, because that is what all of Hydra's launchers take to their workers: its singletons.

    Attributes:
        home: The parent's working directory, which a worker on another machine need not have.
        addresses: Absolute addresses of stores, by what the configuration calls them.
        folder: Where the maps of a sweep lie; None outside of sweeps.
        ready: What to run, where the job was checked in this very process and is the only one.
    """

    def __init__(self) -> None:
        self.home = Path.cwd()
        self.addresses: dict[str, str] = {}
        self.folder: Path | None = None
        self.ready: Callable[[], float] | None = None

    def in_parent_folder(self) -> AbstractContextManager[None]:
        """Enter the parent's working directory, if it is there."""
        return chdir(self.home) if self.home.is_dir() else nullcontext()

    def put_maps(self, sweep: Path, maps: list[tuple[Mapping[str, Any], Grid]]) -> None:
        """Put maps, each with the configuration that it came from, into the folder of a sweep."""
        self.folder = sweep / "maps"
        self.folder.mkdir(parents=True, exist_ok=True)
        for config, grid in maps:
            write_whole(self._file(config), pickle.dumps(grid))

    def map_of(self, config: Mapping[str, Any]) -> Grid | None:
        """Return the map for a configuration, as the parent loaded it; None if it did not send it along."""
        if self.folder is None or not self._file(config).is_file():
            return None
        return _unpacked(self._file(config))

    def _file(self, config: Mapping[str, Any]) -> Path:
        digest = hashlib.sha256(json.dumps(config, sort_keys=True, default=str).encode()).hexdigest()[:16]
        return Path(self.folder or "", f"{digest}.pickle")


@lru_cache(maxsize=4)
def _unpacked(file: Path) -> Grid:
    """Return a map once for the jobs of a process that share it."""
    grid: Grid = pickle.loads(file.read_bytes())
    return grid
