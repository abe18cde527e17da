"""The loop: ants walk, their paths are optimised, the pheromone is updated; cycle after cycle.

``make_loop`` closes over the kernels of the four parts that act while a trial runs, and the compiler inlines
them: a part costs what it does, and nothing for being a part.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import refresh, reset
from acoexp.colony.random import seed_stream
from acoexp.colony.trails import copy_trail, leads_to_goal, read_cells, write_cells
from acoexp.colony.walk import Kernel, Order

NO_PATH = -1
"""What the loop returns if a choice made moves that are not allowed, or never came to an end."""

UNSOUND = -3
"""What the loop returns if a part made pheromone negative or not a number."""

STOPPED = -2
"""What the loop returns if it was told to stop."""


class Own(NamedTuple):
    """The state that each part asked for: whatever its ``prepare`` returned."""

    choice: Any
    diffusion: Any
    post: Any
    update: Any


class Record(NamedTuple):
    """What one trial leaves behind, besides its best path.

    Attributes:
        pairs: int32[iterations, 2], the straight and diagonal moves of the best path found in each cycle; -1
            where all ants were lost.
        lost: int32[iterations], ants lost in each cycle.
        ant_steps: int64[1], moves made by all ants together.
    """

    pairs: NDArray[np.int32]
    lost: NDArray[np.int32]
    ant_steps: NDArray[np.int64]


def make_loop(order: Order, choose: Kernel, diffuse: Kernel, optimise: Kernel | None, update: Kernel) -> Kernel:
    """Return the loop over these kernels, its ants walking in this order, compiled at its first call.

    It takes ``(colony, crowd, own, initial, raw, final, best, cells, record, seed)``: the colony; the ants that
    walk together, or None; the parts' own state; the initial pheromone; trails for the paths as walked and as
    optimised (one object if there is no post-optimiser); trails of two rows for the run's best path, optimised
    and as walked; room for a path as cells; the record to fill; the seed. It returns 0; or the cycle in which
    the post-optimiser returned what is no path; or ``NO_PATH``, ``STOPPED``, ``UNSOUND``.
    """
    walk_together, walk = order(choose, diffuse)
    polish = _polish_by(optimise) if optimise is not None else _leave_as_walked

    @compiled
    def run(
        colony: Any,
        crowd: Any,
        own: Any,
        initial: Any,
        raw: Any,
        final: Any,
        best: Any,
        cells: Any,
        record: Any,
        seed: Any,
    ) -> int:
        _begin(colony, initial, best, record, seed)
        for cycle in range(colony.iterations):
            if colony.stop[0]:
                return STOPPED
            colony.cycle[0] = cycle + 1
            if not walk_together(colony, crowd, own, raw):
                return NO_PATH
            for ant in range(colony.ants):
                if not walk(colony, own, raw, ant):
                    return NO_PATH
                record.ant_steps[0] += raw.steps[ant]
                if raw.length[ant] < np.inf:
                    if not polish(colony, own.post, raw, final, ant, cells):
                        return cycle + 1
                else:
                    final.length[ant] = np.inf
                    record.lost[cycle] += 1
            _note_best(raw, final, best, record, cycle)
            update(colony, own.update, raw, final, best)
            refresh(colony)
        if colony.unsound[0]:
            return UNSOUND
        for row in range(2):
            if best.length[row] < np.inf and not leads_to_goal(colony, best, row):
                return NO_PATH
        return 0

    return run


@compiled
def _begin(colony: Any, initial: Any, best: Any, record: Any, seed: Any) -> None:
    """Bring everything that a former trial may have changed back to the start."""
    seed_stream(colony.random, seed)
    reset(colony, initial)
    colony.untouched[:] = 1.0
    colony.unsound[0] = 0
    best.length[:] = np.inf
    best.steps[:] = 0
    record.pairs[:] = -1
    record.lost[:] = 0
    record.ant_steps[0] = 0


@compiled
def _note_best(raw: Any, final: Any, best: Any, record: Any, cycle: Any) -> None:
    """Record the cycle's best path, walked or optimised, and keep it if it is the run's best so far."""
    shortest, winner = np.inf, -1
    for ant in range(raw.length.size):
        length = min(raw.length[ant], final.length[ant])
        if length < shortest:
            shortest, winner = length, ant
    if winner < 0:
        return
    source = final if final.length[winner] <= raw.length[winner] else raw
    record.pairs[cycle, 0] = source.straight[winner]
    record.pairs[cycle, 1] = source.steps[winner] - source.straight[winner]
    if shortest < best.length[0]:
        copy_trail(source, winner, best, 0)
        copy_trail(raw, winner, best, 1)


@compiled
def _leave_as_walked(colony: Any, own: Any, raw: Any, final: Any, ant: Any, cells: Any) -> bool:
    return True


def _polish_by(optimise: Kernel) -> Kernel:
    """Return a kernel that optimises one ant's path from ``raw`` into ``final``; False if that is no path."""

    @compiled
    def polish(colony: Any, own: Any, raw: Any, final: Any, ant: Any, cells: Any) -> Any:
        count = optimise(colony, own, cells, read_cells(colony, raw, ant, cells))
        return write_cells(colony, cells, count, final, ant)

    return polish
