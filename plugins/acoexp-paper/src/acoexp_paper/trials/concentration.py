"""How far pheromone has gathered after a few cycles (Sect. 4, Figs 7, 8 and 12), as numbers of each trial."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from acoexp.compare.sample import Sample
from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS, path_length
from acoexp.grid.optimum import distances
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver

CYCLES = (6, 8, 10)
"""After which the paper's figures show it; the numbers are of the last."""

ON_SHORTEST, ENTROPY = "pheromone_on_shortest", "pheromone_entropy"
"""Names of the two features: the share of all pheromone that lies on moves of shortest paths; and Shannon's
entropy of its distribution over all moves, as a share of that of an even one."""

_TOLERANCE = 1e-6


def with_concentration(sample: Sample, grid: Grid, settings: Settings) -> Sample:
    """Return a sample, seeds 0..n-1, with both features of its trials."""
    scalars = replace(settings.scalars, iterations=CYCLES[-1])
    solver, on_shortest = Solver(grid, replace(settings, scalars=scalars)), moves_of_shortest_paths(grid)
    levels = (np.nan_to_num(solver.pheromone(seed)) for seed in range(sample.found.size))
    found = np.array([concentration(level, on_shortest) for level in levels])
    return replace(sample, features={**sample.features, ON_SHORTEST: found[:, 0], ENTROPY: found[:, 1]})


def concentration(levels: NDArray[np.float64], on_shortest: NDArray[np.bool_]) -> tuple[float, float]:
    """Return the share on shortest paths, and the entropy; both arrays are [rows, cols, 8]."""
    there = levels[levels > 0.0]
    share = there / there.sum()
    entropy = -float(share @ np.log(share)) / np.log(there.size)
    return float(levels[on_shortest].sum() / levels.sum()), entropy


def moves_of_shortest_paths(grid: Grid) -> NDArray[np.bool_]:
    """Return which moves belong to any shortest path, bool[rows, cols, 8]; moves are allowed both ways."""
    from_start, to_goal = distances(grid.allowed, grid.start), distances(grid.allowed, grid.goal)
    rows, cols = grid.shape
    beyond = np.full((rows + 2, cols + 2), np.inf)
    beyond[1:-1, 1:-1] = to_goal
    on_shortest = np.zeros((rows, cols, 8), dtype=bool)
    for direction, (down, right) in enumerate(DIRECTIONS):
        rest = beyond[1 + down : 1 + down + rows, 1 + right : 1 + right + cols]
        length = from_start + path_length(down == 0 or right == 0, down != 0 and right != 0) + rest
        allowed = (grid.allowed >> direction & 1).astype(bool)
        on_shortest[..., direction] = allowed & (length < grid.optimum + _TOLERANCE)
    return on_shortest
