"""The problem: everything that is known before the first ant sets out, handed to each part's ``prepare``."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.scalars import ColonySettings
from acoexp.grid.field import FieldSettings, PotentialField, potential_field
from acoexp.grid.grid import Cell, Grid
from acoexp.grid.moves import DIRECTIONS
from acoexp.grid.optimum import distances


@dataclass(frozen=True, eq=False)
class Problem:
    """A grid, the settings, and what follows from the two; the same for every trial."""

    grid: Grid
    settings: ColonySettings
    field_settings: FieldSettings

    @cached_property
    def field(self) -> PotentialField:
        """The map's potential field, computed when a part first asks for it."""
        return potential_field(self.grid.obstacles, self.grid.goal, self.field_settings)

    @cached_property
    def distance(self) -> NDArray[np.float64]:
        """Length of the shortest way from each cell to the goal, float64[rows, cols]; inf where there is none."""
        return distances(self.grid.allowed, self.grid.goal)

    @property
    def width(self) -> int:
        """Cells in a row of the bordered map."""
        return self.grid.shape[1] + 2

    def cell(self, place: Cell) -> int:
        """Return a cell's number on the bordered map."""
        return (place[0] + 1) * self.width + place[1] + 1

    def per_cell(self, values: NDArray[Any], border: Any) -> NDArray[Any]:
        """Lay out an array [rows, cols] as kernels index it: [cells] of the bordered map, read-only."""
        laid_out = np.pad(values, 1, constant_values=border).ravel()
        laid_out.flags.writeable = False
        return laid_out

    def per_edge(self, values: NDArray[Any], border: Any) -> NDArray[Any]:
        """Lay out an array [rows, cols, 8] as kernels index it: [edges] of the bordered map, read-only."""
        laid_out = np.pad(values, ((1, 1), (1, 1), (0, 0)), constant_values=border).ravel()
        laid_out.flags.writeable = False
        return laid_out

    def allowed_edges(self, rows: slice = slice(None)) -> NDArray[np.bool_]:
        """Return bool[rows, cols, 8]: which moves are allowed; on some rows, or on all."""
        bits = np.unpackbits(self.grid.allowed[rows, :, None], axis=-1, bitorder="little")
        return bits.view(np.bool_)

    def shared_by_target(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return float64[rows, cols, 8]: for each allowed move the mean of the values of all into its target."""
        allowed = self.allowed_edges()
        row, col, direction = np.nonzero(allowed)
        down, right = np.transpose(DIRECTIONS)
        target = (row + down[direction]) * self.grid.shape[1] + col + right[direction]
        count, total = np.bincount(target), np.bincount(target, values[allowed])
        shared = values.copy()
        shared[allowed] = total[target] / count[target]
        return shared
