"""What a colony carries: the arrays that its kernels read and write, as NamedTuples that numba can take.

Cells are numbered row by row on the map with a border of one blocked cell around it, so that a neighbour is
always there to be looked at: cell = (row + 1) * width + col + 1, width = cols + 2. An edge is a cell and a
direction: edge = cell * 8 + direction. Edges are directed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.pheromone import HIGHEST_POWER
from acoexp.colony.problem import Problem
from acoexp.grid import DIRECTIONS

LOST = 8
"""What a choice returns when no cell is left to go to."""

NO_WAY_HERE = 8
"""The direction an ant came from while it still stands on the start."""

STALE_EDGES = 4096
"""Edges whose weight may wait to be recomputed until an update is over."""


class Trails(NamedTuple):
    """The ways of some ants, one row an ant, each from the start.

    Attributes:
        moves: uint8[ants, cells], the directions taken.
        steps: int32[ants], how many of them.
        straight: int32[ants], how many were straight.
        length: float64[ants], in cells; inf for a lost ant.
    """

    moves: NDArray[np.uint8]
    steps: NDArray[np.int32]
    straight: NDArray[np.int32]
    length: NDArray[np.float64]


class Colony(NamedTuple):
    """One colony at work; what a kernel may read, and (marked *) what only acoexp's own functions change.

    Attributes:
        start, goal: Cells.
        width: Cells in a row of the bordered map.
        offsets: int64[8], from a cell to its neighbour in each direction.
        direction_of: uint8[2 * width + 3], the direction of a move between neighbours, at index
            target - cell + width + 1; 8 where there is none.
        allowed: uint8[cells], bit d set where the move in direction d is allowed.
        desirability: float64[edges], eta^beta; 0 where a move is not allowed.
        alpha, beta, rho, q, tau0: The settings.
        ants, iterations: The settings.
        highest_stored: What ``stored`` may not exceed, lest a weight overflow.
        stored: * float64[edges], pheromone divided by ``scale``; read it by ``level``.
        scale: * float64[1], the factor that all evaporation so far amounts to.
        weight: * float64[edges], stored^alpha * desirability, finite; negative where it waits to be recomputed.
        stale: * int32[], the edges that wait; ``stale_count`` int64[1] tells how many.
        cycle: * int64[1], the cycle, 1..iterations.
        random: * uint64[4], the trial's random numbers; draw by ``uniform``.
        unsound: * uint8[1], not 0 once a part made a level negative or not a number.
        stop: * uint8[1], not 0 once the trial is to end after this cycle.
        on_cells: None where pheromone lies on edges, True where it lies on cells; the compiler knows which, and
            leaves out what only the other needs.
        untouched: * float64[cells], 1 where the ant that is walking has not been, 0 where it has; a factor,
            which costs the choice less than a comparison. It stands last, see ``acoexp.colony.walk``.
    """

    start: np.int64
    goal: np.int64
    width: np.int64
    offsets: NDArray[np.int64]
    direction_of: NDArray[np.uint8]
    allowed: NDArray[np.uint8]
    desirability: NDArray[np.float64]
    alpha: float
    beta: float
    rho: float
    q: float
    tau0: float
    ants: int
    iterations: int
    highest_stored: float
    stored: NDArray[np.float64]
    scale: NDArray[np.float64]
    weight: NDArray[np.float64]
    stale: NDArray[np.int32]
    stale_count: NDArray[np.int64]
    cycle: NDArray[np.int64]
    random: NDArray[np.uint64]
    unsound: NDArray[np.uint8]
    stop: NDArray[np.uint8]
    on_cells: bool | None
    untouched: NDArray[np.float64]


def new_trails(ants: int, cells: int) -> Trails:
    """Return empty trails for so many ants on a map of so many cells (border included)."""
    return Trails(
        np.empty((ants, cells), dtype=np.uint8),
        np.zeros(ants, dtype=np.int32),
        np.zeros(ants, dtype=np.int32),
        np.full(ants, np.inf),
    )


def direction_offsets(width: int) -> NDArray[np.int64]:
    """Return int64[8]: from a cell to its neighbour in each direction, on a bordered map so wide."""
    return np.array([down * width + right for down, right in DIRECTIONS], dtype=np.int64)


def offset_directions(width: int) -> NDArray[np.uint8]:
    """Return uint8[2 * width + 3], the inverse: ``directions[offset + width + 1]``; 8 where there is none."""
    directions = np.full(2 * width + 3, 8, dtype=np.uint8)
    directions[direction_offsets(width) + width + 1] = np.arange(8)
    return directions


def new_colony(problem: Problem, desirability: NDArray[np.float64], stop: NDArray[np.uint8]) -> Colony:
    """Return a colony for one worker, to be used for one trial after the other.

    Args:
        problem: What is to be solved.
        desirability: float64[edges], eta^beta, 0 where a move is not allowed; shared between workers.
        stop: uint8[1], by which whoever holds it ends the trial.
    """
    settings = problem.settings
    allowed = problem.per_cell(problem.grid.allowed, border=0)
    cells = allowed.size
    return Colony(
        start=np.int64(problem.cell(problem.grid.start)),
        goal=np.int64(problem.cell(problem.grid.goal)),
        width=np.int64(problem.width),
        offsets=direction_offsets(problem.width),
        direction_of=offset_directions(problem.width),
        allowed=allowed,
        desirability=desirability,
        alpha=settings.alpha,
        beta=settings.beta,
        rho=settings.rho,
        q=settings.q,
        tau0=settings.tau0,
        ants=settings.ants,
        iterations=settings.iterations,
        highest_stored=HIGHEST_POWER ** (1.0 / max(settings.alpha, 1.0)),
        stored=np.empty(cells * 8),
        scale=np.ones(1),
        weight=np.empty(cells * 8),
        stale=np.empty(min(STALE_EDGES, cells * 8), dtype=np.int32),
        stale_count=np.zeros(1, dtype=np.int64),
        cycle=np.zeros(1, dtype=np.int64),
        random=np.zeros(4, dtype=np.uint64),
        unsound=np.zeros(1, dtype=np.uint8),
        stop=stop,
        on_cells=True if settings.pheromone == "cells" else None,
        untouched=np.ones(cells),
    )
