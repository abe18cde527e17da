"""What a colony carries: the arrays that its kernels read and write, as NamedTuples that numba can take.

Cells are numbered row by row on the map with a border of one blocked cell around it, so that a neighbour is
always there to be looked at: cell = (row + 1) * width + col + 1, width = cols + 2. An edge is a cell and a
direction: edge = cell * 8 + direction. Edges are directed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Kernel = Callable[..., Any]
"""A compiled function."""

LOST = 8
"""What a choice returns when no cell is left to go to."""

BACK = 9
"""What a choice returns to give the ant's last move back; the cell that it leaves stays tabu for it."""

NO_WAY_HERE = 8
"""The direction an ant came from while it still stands on the start."""


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
        patience: Cycles in a row without a better path after which the trial ends.
        max_steps: Moves, those back too, after which an ant is lost.
        highest_stored: What ``stored`` may not exceed, lest a weight overflow.
        stored: * float64[edges], pheromone divided by ``scale``; read it by ``level``.
        scale: * float64[1], the factor that all evaporation so far amounts to.
        weight: * float64[edges], stored^alpha * desirability, finite; negative where it waits to be recomputed.
        stale: * int32[], the edges that wait; ``stale_count`` int64[1] tells how many.
        background: * float64[1], what is stored on all edges that nobody changed.
        changed: * int32[patches], where pheromone may have been changed since the trial began;
            ``changed_count`` int64[1] tells how many patches, ``is_changed`` uint8[patches] which.
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
    patience: int
    max_steps: int
    highest_stored: float
    stored: NDArray[np.float64]
    scale: NDArray[np.float64]
    weight: NDArray[np.float64]
    stale: NDArray[np.int32]
    stale_count: NDArray[np.int64]
    background: NDArray[np.float64]
    changed: NDArray[np.int32]
    changed_count: NDArray[np.int64]
    is_changed: NDArray[np.uint8]
    cycle: NDArray[np.int64]
    random: NDArray[np.uint64]
    unsound: NDArray[np.uint8]
    stop: NDArray[np.uint8]
    on_cells: bool | None
    untouched: NDArray[np.float64]


class Crowd(NamedTuple):
    """Ants that walk at the same time.

    Attributes:
        cell: int64[ants], where each is.
        walks: bool[ants], whether it walks on.
        untouched: float64[ants, cells], to each ant what ``Colony.untouched`` is to one that walks alone.
    """

    cell: NDArray[np.int64]
    walks: NDArray[np.bool_]
    untouched: NDArray[np.float64]


class GivenUp(NamedTuple):
    """Cells that ants stepped back from, which are on no trail and stay tabu until the ant's walk is over.

    Attributes:
        cells: int32[rows, cells]: a row for each ant that walks at the same time.
        number: int64[rows], how many of them each ant gave up.
    """

    cells: NDArray[np.int32]
    number: NDArray[np.int64]


class Kernels(NamedTuple):
    """What acts while a trial runs: one kernel for each part, by group. ``post=None`` leaves paths as walked."""

    choice: Kernel
    diffusion: Kernel
    post: Kernel | None
    update: Kernel


class Own(NamedTuple):
    """The state that each of these parts asked for: whatever its ``prepare`` returned."""

    choice: Any
    diffusion: Any
    post: Any
    update: Any


class Prepared(NamedTuple):
    """What the parts have prepared for all trials.

    Attributes:
        desirability: eta^beta, float64[edges], 0 where a move is not allowed.
        initial: The initial pheromone, float64[1] or float64[edges].
        own: The parts' own states.
    """

    desirability: NDArray[np.float64]
    initial: NDArray[np.float64]
    own: Own


class Pair(NamedTuple):
    """Two ants that look for each other: of each array a row is the one's from the start, one the other's.

    Attributes:
        cell: int64[2], where each is.
        walks: bool[2], whether it walks on.
        place: int32[2, cells], after how many moves it came to a cell, -1 where that is not on its way.
    """

    cell: NDArray[np.int64]
    walks: NDArray[np.bool_]
    place: NDArray[np.int32]


class Facing(NamedTuple):
    """The colony at the goal, where ants set out from both ends; to it the goal is the start.

    Attributes:
        colony: The colony; its cycle, random numbers and marks are those of the one at the start.
        pair: The ants that walk.
        own, initial: As in ``Prepared``, for the way back.
        raw, final, best: As in ``Room``, each path from goal to start.
    """

    colony: Colony
    pair: Pair
    own: Own
    initial: NDArray[np.float64]
    raw: Trails
    final: Trails
    best: Trails


class Room(NamedTuple):
    """What the loop works on: one thread's memory, used for one trial after the other.

    Attributes:
        colony: The colony.
        crowd: Its ants, where they walk together; else None.
        facing: The colony at the goal, where ants set out from both ends; else None.
        given_up: What they stepped back from.
        made: int64[ants], the moves that each ant of the cycle made, those back too.
        own: The parts' own states.
        initial: The initial pheromone, as in ``Prepared``.
        raw, final: The ways of a cycle's ants, as walked and as optimised; one object if there is no
            post-optimiser.
        best: Two rows: the run's best path so far, and that path as it was walked.
        cells: int32[cells], a path as cells while a post-optimiser works on it.
    """

    colony: Colony
    crowd: Crowd | None
    facing: Facing | None
    given_up: GivenUp
    made: NDArray[np.int64]
    own: Own
    initial: NDArray[np.float64]
    raw: Trails
    final: Trails
    best: Trails
    cells: NDArray[np.int32]


class Record(NamedTuple):
    """What one trial leaves behind, besides its best path.

    Attributes:
        pairs: int32[iterations, 2], the straight and diagonal moves of the best path found in each cycle; -1
            where all ants were lost.
        lost: int32[iterations], ants lost in each cycle.
        ant_steps: int64[iterations], moves made by all ants together in each cycle.
    """

    pairs: NDArray[np.int32]
    lost: NDArray[np.int32]
    ant_steps: NDArray[np.int64]
