"""``map=rooms``: rooms side by side, with doors in the walls between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from acoexp.errors import SettingsError
from acoexp.maps.generated import GeneratedMap
from acoexp.maps.lattice import Openings, open_walls, spans
from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class RoomMap(GeneratedMap):
    """Square rooms with doors at random places, drawn from a seed; the last rooms take what is left over."""

    kind = "rooms"

    side: int = parameter(7, "side of a room in cells; walls have one", minimum=1, maximum=2048)
    door: int = parameter(1, "width of a door in cells, at most that of a room", minimum=1, maximum=2048)
    doors: float = parameter(
        0.5, "share of the walls with a door, beside those that each room needs", minimum=0.0, maximum=1.0
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.door > self.side:
            raise SettingsError(f"map.door: expected at most map.side, which is {self.side}; got {self.door}")

    def obstacles(self, rng: Generator) -> NDArray[np.bool_]:
        """Draw which walls have a door, and where in them."""
        heights, widths = (spans(cells, self.side) for cells in self.size)
        walls = open_walls(rng, len(heights) // 2 + 1, len(widths) // 2 + 1, self.doors)
        obstacles = np.zeros(self.size, dtype=bool)
        obstacles[heights.cumsum()[:-1:2]] = True
        obstacles[:, widths.cumsum()[:-1:2]] = True
        self._cut(rng, obstacles, walls.below, heights, widths)
        self._cut(rng, obstacles.T, walls.beside.T, widths, heights)
        return obstacles

    def _cut(
        self,
        rng: Generator,
        obstacles: NDArray[np.bool_],
        below: Openings,
        heights: NDArray[np.int64],
        widths: NDArray[np.int64],
    ) -> None:
        """Cut doors into the walls that lie below rooms."""
        above, room = np.nonzero(below)
        rows = heights.cumsum()[2 * above]
        width = widths[2 * room]
        cut = np.minimum(self.door, width)
        first = widths.cumsum()[2 * room] - width + (rng.random(room.size) * (width - cut + 1)).astype(np.int64)
        for place in range(self.door):
            inside = place < cut
            obstacles[rows[inside], first[inside] + place] = False

    def label(self) -> str:
        """Return the rooms' side, and how wide and many the doors are."""
        return f"r{self.side}-w{self.door}-d{self.doors:g}"
