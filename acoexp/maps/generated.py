"""Maps by chance: drawn from a seed, again and again until a way leads from start to goal.

The random numbers are those of NumPy's PCG64, and of it only ``random`` and ``integers``, so that a seed means the
same map under any version.
"""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.random import PCG64, Generator
from numpy.typing import NDArray

from acoexp.errors import MapError, SettingsError, shown
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import MOVE_RULES
from acoexp.maps.source import MapSource
from acoexp.parameters import parameter, values_of

LARGEST_SIDE = 2048
"""Rows and columns that a drawn map may have."""

DRAWS = 100
"""Maps that are drawn until one has a way."""


@dataclass(frozen=True, kw_only=True)
class GeneratedMap(MapSource):
    """A map that a seed stands for."""

    kind: ClassVar[str]
    numbered = "seed"

    size: tuple[int, int] = parameter((50, 50), f"rows and columns, each from 1 to {LARGEST_SIDE}")
    seed: int = parameter(0, "whole number that the map follows from", minimum=0, maximum=2**64 - 1)
    start: Cell | None = parameter(None, "start as [row, column], kept free; else the top left corner")
    goal: Cell | None = parameter(None, "goal as [row, column], kept free; else the bottom right corner")
    moves: str = parameter("no_squeeze", "rule for diagonals", choices=MOVE_RULES)

    def __post_init__(self) -> None:
        if not all(1 <= side <= LARGEST_SIDE for side in self.size):
            raise SettingsError(
                f"map.size: expected rows and columns, each from 1 to {LARGEST_SIDE}; got {shown(list(self.size))}"
            )
        for key, cell in (("start", self.start), ("goal", self.goal)):
            if cell is not None and not all(0 <= at < side for at, side in zip(cell, self.size, strict=True)):
                last = [side - 1 for side in self.size]
                raise SettingsError(f"map.{key}: expected a cell from [0, 0] to {last}; got {shown(list(cell))}")

    def load(self) -> Grid:
        """Draw maps until one has a way, and return its grid; its parameters are in its metadata.

        Raises:
            MapError: if none of ``DRAWS`` maps has one.
        """
        rows, cols = self.size
        name = f"{self.kind}-{rows}x{cols}-{self.label()}-s{self.seed}"
        start, goal = self.start or (0, 0), self.goal or (rows - 1, cols - 1)
        rng = Generator(PCG64(self.seed))
        for _ in range(DRAWS):
            obstacles = self.obstacles(rng)
            obstacles[start] = obstacles[goal] = False
            if _joined(obstacles, start, goal, self.moves):
                metadata = {key: str(value) for key, value in values_of(self).items()}
                return Grid(obstacles, start=start, goal=goal, moves=self.moves, name=name, metadata=metadata)
        raise MapError(
            f"map {name}: expected settings under which a way leads from start {start} to goal {goal}; it did on "
            f"none of {DRAWS} maps"
        )

    @abstractmethod
    def obstacles(self, rng: Generator) -> NDArray[np.bool_]:
        """Draw the obstacles of one map, bool[rows, cols]."""

    @abstractmethod
    def label(self) -> str:
        """Return what tells maps of this kind and size apart, but for the seed."""


def _joined(obstacles: NDArray[np.bool_], start: Cell, goal: Cell, moves: str) -> bool:
    """Tell whether a way leads from one cell to another.

    Only the rule ``free`` joins cells that no straight moves do: any other diagonal has a free cell beside it.
    """
    from scipy.ndimage import label

    parts, _ = label(~obstacles, np.ones((3, 3)) if moves == "free" else None)
    return bool(parts[start] == parts[goal])
