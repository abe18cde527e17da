"""The handover: what a worker needs from its parent, whichever launcher runs it and on whichever machine.

Maps lie as they were loaded in the sweep's folder; relative addresses travel as absolute ones; and the options
that the parent has read are in memory, so that a worker composes its job without the parent's files.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, chdir, nullcontext
from dataclasses import asdict
from functools import lru_cache
from io import BytesIO
from itertools import count
from pathlib import Path
from secrets import token_hex
from typing import Any

import numpy as np
from hydra.core.singleton import Singleton

from acoexp.command.results.records import BATCH, TRIAL
from acoexp.console.whole import write_whole
from acoexp.errors import SettingsError
from acoexp.grid.frame import Frame
from acoexp.grid.grid import Grid
from acoexp.tracking.options import EXPERIMENT_VARIABLE


class Handover(metaclass=Singleton):
    """One for each process, because that is what all of Hydra's launchers take to their workers: its singletons.

    Attributes:
        home: The parent's working directory, which a worker on another machine need not have.
        addresses: Absolute addresses of stores, by what the configuration calls them.
        experiment: What the parent's environment calls the experiment, if it does.
        folder: Where the maps of a sweep lie; None outside of sweeps.
        ready: What to run, where the job was checked in this very process and is the only one.
    """

    def __init__(self) -> None:
        self.home = Path.cwd()
        self.addresses: dict[str, str] = {}
        self.experiment = os.environ.get(EXPERIMENT_VARIABLE)
        self.folder: Path | None = None
        self.ready: Callable[[], float] | None = None
        self._sweep = ""

    def in_parent_folder(self) -> AbstractContextManager[None]:
        """Enter the parent's working directory, if it is there."""
        return chdir(self.home) if self.home.is_dir() else nullcontext()

    def put_maps(self, sweep: Path, maps: list[tuple[Mapping[str, Any], Grid]]) -> None:
        """Put maps, each with the configuration that it came from, into the folder of a sweep."""
        self.folder = sweep / "maps"
        self.folder.mkdir(parents=True, exist_ok=True)
        self._sweep = token_hex(8)
        for config, grid in maps:
            write_whole(self._file(config), _packed(grid))

    def map_of(self, config: Mapping[str, Any]) -> Grid | None:
        """Return the map for a configuration, as the parent loaded it; None if it did not send it along."""
        if self.folder is None or not self._file(config).is_file():
            return None
        file = self._file(config)
        return _unpacked(file, file.stat().st_mtime_ns)

    def own_folder(self, folder: Path) -> Path:
        """Return a job's folder; one within it for every further job of a sweep whose pattern leads there too.

        Raises:
            SettingsError: if it lies outside of the sweep's, which would not find there what the job leaves.
        """
        if self.folder is None:
            return folder
        if not folder.resolve().is_relative_to(self.folder.parent.resolve()):
            sweep = self.folder.parent
            raise SettingsError(f"hydra.sweep.subdir: expected a folder within {sweep}; got {folder}")
        for number in count(1):
            claim = hashlib.sha256(f"{self._sweep} {folder.absolute()} {number}".encode()).hexdigest()[:16]
            try:
                (self.folder / f"{claim}.job").touch(exist_ok=False)
            except FileExistsError:
                continue
            own = folder if number == 1 else folder / str(number)
            if (own / TRIAL).exists() or (own / BATCH).exists():  # of an earlier sweep
                continue
            own.mkdir(parents=True, exist_ok=True)
            return own
        raise AssertionError

    def _file(self, config: Mapping[str, Any]) -> Path:
        digest = hashlib.sha256(json.dumps(config, sort_keys=True, default=str).encode()).hexdigest()[:16]
        return Path(self.folder or "", f"{digest}.npz")


def _packed(grid: Grid) -> bytes:
    """Return a map as NumPy's archive, which holds no code."""
    about = {key: getattr(grid, key) for key in ("start", "goal", "moves", "name", "metadata")}
    about["frame"] = None if grid.frame is None else asdict(grid.frame)
    buffer = BytesIO()
    text = json.dumps(about, default=str).encode()
    np.savez_compressed(buffer, obstacles=grid.obstacles, about=np.frombuffer(text, np.uint8))
    return buffer.getvalue()


@lru_cache(maxsize=4)
def _unpacked(file: Path, written: int) -> Grid:
    """Return a map once for the jobs of a process that share it; another that was written in its place is read."""
    with np.load(file, allow_pickle=False) as archive:
        about = json.loads(archive["about"].tobytes())
        start, goal = tuple(about.pop("start")), tuple(about.pop("goal"))
        frame = about.pop("frame", None)
        if frame is not None:
            frame = Frame(**{**frame, "origin": tuple(frame["origin"])})
        return Grid(archive["obstacles"], start=start, goal=goal, frame=frame, **about)
