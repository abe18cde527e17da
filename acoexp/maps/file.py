"""``map=file map.path=...``: a map from the user's own text file."""

from __future__ import annotations

import os
import stat
from dataclasses import dataclass
from pathlib import Path

from acoexp.console.plain import printable
from acoexp.errors import MapError, shown
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.source import MapSource
from acoexp.maps.text import parse_map
from acoexp.parameters import REQUIRED, parameter

LARGEST = 4 * 2**20
"""Bytes that a map's file may have: 2000 x 2000 cells of '.' and '#', which take some seconds to read."""

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
}
"""What is no file, and would be read without an end, or waited for."""


@dataclass(frozen=True, kw_only=True)
class MapFile(MapSource):
    """Your own map from a text file: '.' and '#', or 0 and 1 separated by blanks; S and G mark the ends."""

    path: str = parameter(REQUIRED, "the file, relative to the working directory")
    start: Cell | None = parameter(None, "start as [row, column], 0-based; else S, else the top left corner")
    goal: Cell | None = parameter(None, "goal as [row, column]; else G, else the bottom right corner")
    moves: str | None = parameter(
        None, "rule for diagonals; else the file's own line '; moves: ...', else no_squeeze", choices=MOVE_RULES
    )

    def load(self) -> Grid:
        """Read the file and return its grid."""
        try:
            path = Path(self.path).expanduser()
            text = self._content(path).decode("utf-8-sig")
        except MapError:
            raise
        except UnicodeDecodeError as problem:
            raise MapError(f"map.path: expected a text file in UTF-8; got {shown(self.path)}") from problem
        except (OSError, ValueError, RuntimeError) as problem:
            raise self._refusal(getattr(problem, "strerror", None) or str(problem)) from problem
        return parse_map(text, name=printable(path.name), start=self.start, goal=self.goal, moves=self.moves)

    def _content(self, path: Path) -> bytes:
        """Return what is in a file, if it is a file and no larger than a map can be."""
        kind = _KINDS.get(stat.S_IFMT(path.stat().st_mode))
        if kind is not None:
            raise self._refusal(kind)
        # some files of the system's have nothing to read yet, and would be waited for
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | os.O_NONBLOCK)) as file:
            content = file.read(LARGEST + 1) or b""
        if len(content) > LARGEST:
            raise self._refusal(f"more than {LARGEST // 2**20} MiB, the most that a map may have")
        return content

    def _refusal(self, reason: str) -> MapError:
        return MapError(f"map.path: expected a readable text file; got {shown(self.path)} ({reason})")
