"""``map=maze``: a perfect maze, one way between any two places; or with some of its walls taken away."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from acoexp.maps.generated import GeneratedMap
from acoexp.maps.lattice import open_walls, spans
from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class MazeMap(GeneratedMap):
    """A maze with one way between any two places, drawn from a seed; the last corridor takes what is left over."""

    kind = "maze"

    width: int = parameter(1, "width of a corridor in cells; walls have one", minimum=1, maximum=2048)
    loops: float = parameter(
        0.0, "share of its walls that are taken away, which makes loops", minimum=0.0, maximum=1.0
    )

    def obstacles(self, rng: Generator) -> NDArray[np.bool_]:
        """Draw a maze of corridors of one cell, and widen them."""
        heights, widths = (spans(cells, self.width) for cells in self.size)
        walls = open_walls(rng, len(heights) // 2 + 1, len(widths) // 2 + 1, self.loops)
        narrow = np.ones((len(heights), len(widths)), dtype=bool)
        narrow[::2, ::2] = False
        narrow[1::2, ::2], narrow[::2, 1::2] = ~walls.below, ~walls.beside
        return narrow.repeat(heights, axis=0).repeat(widths, axis=1)

    def label(self) -> str:
        """Return the width, and the loops if there are any."""
        return f"w{self.width}" + (f"-l{self.loops:g}" if self.loops else "")
