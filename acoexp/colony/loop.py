"""The loop: ants walk, their paths are optimised, the pheromone is updated; cycle after cycle.

``make_loop`` closes over the kernels of the four parts that act while a trial runs, and the compiler inlines
them: a part costs what it does, and nothing for being a part.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.background import reset
from acoexp.colony.changes import refresh
from acoexp.colony.compiled import compiled, compiled_for_python
from acoexp.colony.random import seed_stream
from acoexp.colony.state import Kernel, Kernels
from acoexp.colony.steps import idle
from acoexp.colony.trails import copy_trail, leads_to_goal, read_cells, write_cells
from acoexp.colony.verdicts import NO_PATH, STOPPED, UNSOUND
from acoexp.colony.walk import Order


def make_loop(order: Order, steps_back: bool, kernels: Kernels) -> Kernel:
    """Return the loop over these kernels, its ants walking in this order, compiled at its first call.

    It takes ``(room, record, seed)``: what it works on, a :class:`~acoexp.colony.state.Room`; the record to fill;
    the seed, uint64. It returns 0; or the cycle in which the post-optimiser returned what is no path; or
    ``NO_PATH``, ``STOPPED``, ``UNSOUND``.
    """
    walk_together, walk = order.walk(kernels.choice, kernels.diffusion, steps_back)
    begin_facing, close_facing = order.facing(kernels.update)
    polish = idle if kernels.post is None else _polish_by(kernels.post)
    update = kernels.update

    @compiled_for_python
    def run(room: Any, record: Any, seed: Any) -> int:
        colony, own, raw, final, best = room.colony, room.own, room.raw, room.final, room.best
        _begin(room, record, seed)
        begin_facing(room)
        in_vain = 0
        for cycle in range(colony.iterations):
            if colony.stop[0]:
                return STOPPED
            colony.cycle[0] = cycle + 1
            if not walk_together(room):
                return NO_PATH
            for ant in range(colony.ants):
                if not walk(room, ant):
                    return NO_PATH
                record.ant_steps[cycle] += room.made[ant]
                if raw.length[ant] < np.inf:
                    if not polish(room, ant):
                        return cycle + 1
                else:
                    final.length[ant] = np.inf
                    record.lost[cycle] += 1
            in_vain = 0 if _note_best(raw, final, best, record, cycle) else in_vain + 1
            update(colony, own.update, raw, final, best)
            refresh(colony)
            close_facing(room)
            if in_vain == colony.patience:
                break
        if colony.unsound[0]:
            return UNSOUND
        for row in range(2):
            if best.length[row] < np.inf and not leads_to_goal(colony, best, row):
                return NO_PATH
        return 0

    return run


@compiled
def _begin(room: Any, record: Any, seed: Any) -> None:
    """Bring everything that a former trial may have changed back to the start."""
    colony, best = room.colony, room.best
    seed_stream(colony.random, seed)
    reset(colony, room.initial)
    colony.unsound[0] = 0
    best.length[:] = np.inf
    best.steps[:] = 0
    record.pairs[:] = -1
    record.lost[:] = 0
    record.ant_steps[:] = 0


@compiled
def _note_best(raw: Any, final: Any, best: Any, record: Any, cycle: Any) -> bool:
    """Record the cycle's best path, walked or optimised; tell whether it is the best so far, and kept."""
    shortest, winner = np.inf, -1
    for ant in range(raw.length.size):
        length = min(raw.length[ant], final.length[ant])
        if length < shortest:
            shortest, winner = length, ant
    if winner < 0:
        return False
    source = final if final.length[winner] <= raw.length[winner] else raw
    record.pairs[cycle, 0] = source.straight[winner]
    record.pairs[cycle, 1] = source.steps[winner] - source.straight[winner]
    if shortest >= best.length[0]:
        return False
    copy_trail(source, winner, best, 0)
    copy_trail(raw, winner, best, 1)
    return True


def _polish_by(optimise: Kernel) -> Kernel:
    """Return a kernel that optimises one ant's path from ``raw`` into ``final``; False if that is no path."""

    @compiled
    def polish(room: Any, ant: Any) -> Any:
        colony, cells = room.colony, room.cells
        count = optimise(colony, room.own.post, cells, read_cells(colony, room.raw, ant, cells))
        return write_cells(colony, cells, count, room.final, ant)

    return polish
