"""``map=rectangles``: rectangles at random places, which may overlap."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from acoexp.errors import SettingsError, shown
from acoexp.maps.generated import LARGEST_SIDE, GeneratedMap
from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class RectangleMap(GeneratedMap):
    """Rectangles of obstacles at random places, drawn from a seed until there is a way."""

    kind = "rectangles"

    count: int = parameter(30, "how many rectangles; they may overlap", minimum=0, maximum=100_000)
    sides: tuple[int, int] = parameter((2, 8), "shortest and longest side of a rectangle, in cells")

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 1 <= self.sides[0] <= self.sides[1] <= LARGEST_SIDE:
            raise SettingsError(
                f"map.sides: expected the shortest and the longest side, from 1 to {LARGEST_SIDE}; got "
                f"{shown(list(self.sides))}"
            )

    def obstacles(self, rng: Generator) -> NDArray[np.bool_]:
        """Draw sides, then places at which they fit; a side longer than the map is as long as the map."""
        sides = np.minimum(rng.integers(*self.sides, size=(self.count, 2), endpoint=True), self.size)
        top, left = (rng.random((self.count, 2)) * (np.subtract(self.size, sides) + 1)).astype(np.int64).T
        bottom, right = top + sides[:, 0], left + sides[:, 1]
        # how many begin at a cell less how many ended before it, summed up, is how many lie on it
        changes = np.zeros(np.add(self.size, 1), dtype=np.int32)
        for row, col, change in ((top, left, 1), (top, right, -1), (bottom, left, -1), (bottom, right, 1)):
            np.add.at(changes, (row, col), change)
        covered: NDArray[np.bool_] = changes.cumsum(axis=0).cumsum(axis=1)[:-1, :-1] > 0
        return covered

    def label(self) -> str:
        """Return how many, and their sides."""
        return f"n{self.count}-l{self.sides[0]}-{self.sides[1]}"
