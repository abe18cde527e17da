"""``map=file map.path=...``: a map from the user's own text file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from acoexp.errors import MapError
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.source import MapSource
from acoexp.maps.text import parse_map
from acoexp.parameters import REQUIRED, parameter


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
            text = path.read_text(encoding="utf-8-sig")
        except UnicodeDecodeError as problem:
            raise MapError(f"map.path: expected a text file in UTF-8; got {self.path!r}") from problem
        except (OSError, ValueError, RuntimeError) as problem:
            reason = getattr(problem, "strerror", None) or str(problem)
            raise MapError(f"map.path: expected a readable text file; got {self.path!r} ({reason})") from problem
        return parse_map(text, name=path.name, start=self.start, goal=self.goal, moves=self.moves)
