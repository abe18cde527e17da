"""``map=file map.path=...``: a map from the user's own file, of text or of NumPy's."""

from __future__ import annotations

from dataclasses import dataclass

from acoexp.console.plain import printable
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.cells import marked_grid
from acoexp.maps.npy import LARGEST_ARRAY, parse_npy
from acoexp.maps.reading import read_bytes, read_text
from acoexp.maps.source import MapSource
from acoexp.maps.text import parse_map
from acoexp.parameters import REQUIRED, parameter


@dataclass(frozen=True, kw_only=True)
class MapFile(MapSource):
    """Your own map from a file: '.' and '#' with S and G, or 0 and 1 as text, CSV, MATLAB, Python or .npy."""

    path: str = parameter(REQUIRED, "the file, relative to the working directory")
    start: Cell | None = parameter(None, "start as [row, column], 0-based; else S or 2, else the top left corner")
    goal: Cell | None = parameter(None, "goal as [row, column]; else G or 3, else the bottom right corner")
    moves: str | None = parameter(
        None, "rule for diagonals; else the file's own line '; moves: ...', else no_squeeze", choices=MOVE_RULES
    )

    def load(self) -> Grid:
        """Read the file and return its grid."""
        if self.path.lower().endswith(".npy"):
            path, content = read_bytes(self.path, "map.path", "NumPy file", LARGEST_ARRAY)
            name = printable(path.name)
            cells = parse_npy(content, name)
            return marked_grid(cells, ("2", "3"), name=name, start=self.start, goal=self.goal, moves=self.moves)
        path, text = read_text(self.path, "map.path")
        return parse_map(text, name=printable(path.name), start=self.start, goal=self.goal, moves=self.moves)
