"""The problem: everything that is known before the first ant sets out, handed to each part's ``prepare``."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.field import FieldSettings, PotentialField, potential_field
from acoexp.grid import DIRECTIONS, Cell, Grid
from acoexp.parameters import parameter


@dataclass(frozen=True, kw_only=True)
class ColonySettings:
    """The scalars of a colony; the defaults are those of Liu et al. 2017, Sect. 5, where it gives them."""

    alpha: float = parameter(1.1, "weight of pheromone in the choice", minimum=0.0, maximum=100.0)
    beta: float = parameter(12.0, "weight of the heuristic in the choice", minimum=0.0, maximum=100.0)
    rho: float = parameter(0.5, "share of the pheromone that evaporates in a cycle", minimum=0.0, maximum=1.0)
    ants: int = parameter(10, "ants that walk in a cycle", minimum=1, maximum=100_000)
    iterations: int = parameter(200, "cycles in a trial", minimum=1, maximum=1_000_000)
    q: float = parameter(
        1.0, "pheromone that an ant spreads over its path; not in the paper", minimum=1e-100, maximum=1e100
    )
    tau0: float = parameter(
        1.0, "pheromone everywhere at the start; not in the paper", minimum=1e-100, maximum=1e100
    )
    pheromone: str = parameter(
        "edges",
        "where pheromone lies (Eqs 18, 19 or Sect. 3.4, step 3); all edges into a cell share its level",
        choices=("edges", "cells"),
    )
    order: str = parameter(
        "in_turn",
        "how the ants of a cycle walk: one after another, or one step each in turn",
        choices=("in_turn", "lock_step"),
    )


@dataclass(frozen=True, eq=False)
class Problem:
    """A grid, the settings, and what follows from the two; the same for every trial."""

    grid: Grid
    settings: ColonySettings
    field_settings: FieldSettings

    @cached_property
    def field(self) -> PotentialField:
        """The map's potential field, computed when a part first asks for it."""
        return potential_field(self.grid, self.field_settings)

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

    def allowed_edges(self) -> NDArray[np.bool_]:
        """Return bool[rows, cols, 8]: which moves are allowed."""
        bits = np.unpackbits(self.grid.allowed[..., None], axis=-1, bitorder="little")
        return bits.astype(bool)

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
