"""Walking: how the ants of a cycle get from the start to the goal, one after another or all together.

An order makes two kernels from those of choice and diffusion: ``walk_together(room)``, called once a cycle, and
``walk(room, ant)``, called for each ant after that. One of the two does the work, the other is ``idle``. Both
write the ants' ways into ``room.raw``, those of lost ants too, and return False if a choice made a move that is
not allowed. An ant that has made so many moves as it may, or as there are cells, is lost.

At a dead end an ant is lost or, if ants step back, gives its last move back and chooses again; the cell that it
leaves stays tabu for it, so that it makes at most twice as many moves as there are cells. This is the turn-back
search that Liu et al. 2017 cite (Wang et al. 2008).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.state import BACK, LOST, NO_WAY_HERE, Colony, Kernel
from acoexp.colony.steps import came_by, idle, is_allowed, leaves
from acoexp.colony.tabu import forget, touch
from acoexp.colony.trails import measure


def at_one_end(update: Kernel) -> tuple[Kernel, Kernel]:
    """Return what begins and what closes the cycles of a second colony, where there is none."""
    return idle, idle


class Order(NamedTuple):
    """An order in which the ants of a cycle walk.

    Attributes:
        walk: Makes the two kernels of choice, diffusion, and whether ants step back.
        facing: Makes two kernels of the one that updates: ``begin(room)``, called when a trial begins, and
            ``close(room)``, called after each update; they see to a second colony, if there is one.
    """

    walk: Callable[[Kernel, Kernel, bool], tuple[Kernel, Kernel]]
    facing: Callable[[Kernel], tuple[Kernel, Kernel]] = at_one_end


def in_turn(choose: Kernel, diffuse: Kernel, steps_back: bool) -> tuple[Kernel, Kernel]:
    """Each ant sets out when the one before has arrived, or is lost."""

    @compiled
    def walk(room: Any, ant: Any) -> Any:
        colony, own, raw, given_up = room.colony, room.own, room.raw, room.given_up
        cell, came = colony.start, NO_WAY_HERE
        touch(colony, cell)
        steps = straight = left = 0
        move = LOST
        limit = min(colony.max_steps, raw.moves.shape[1])
        while cell != colony.goal and steps < limit:
            diffuse(colony, own.diffusion, ant, cell, came)
            move = choose(colony, own.choice, ant, cell, came)
            if is_allowed(colony.allowed[np.uintp(cell)], move):
                raw.moves[np.uintp(ant), np.uintp(steps)] = move
                steps += 1
                straight += 1 - (move & 1)
                cell += colony.offsets[np.uintp(move)]
                touch(colony, cell)
                came = move
            elif steps > 0 and leaves(move, steps_back):
                given_up.cells[0, left] = cell
                left += 1
                limit = min(colony.max_steps - 2 * left, raw.moves.shape[1])  # each was gone to and left
                cell -= colony.offsets[came_by(raw, ant, steps)]
                straight -= 1 - (came_by(raw, ant, steps) & 1)
                steps -= 1
                came = came_by(raw, ant, steps)
            else:
                break
        measure(raw, ant, steps, straight)
        if cell != colony.goal:
            raw.length[ant] = np.inf
        room.made[ant] = steps + 2 * left
        forget(colony, raw, ant, given_up.cells[0], left)
        return cell == colony.goal or steps >= limit or LOST <= move <= BACK

    return idle, walk


def lock_step(choose: Kernel, diffuse: Kernel, steps_back: bool) -> tuple[Kernel, Kernel]:
    """All set out together, and make one step each in turn, until every one has arrived or is lost."""

    @compiled
    def step(colony: Any, room: Any, ant: Any) -> Any:
        crowd, own, raw, given_up = room.crowd, room.own, room.raw, room.given_up
        cell, steps = crowd.cell[ant], raw.steps[ant]
        came = came_by(raw, ant, steps)
        diffuse(colony, own.diffusion, ant, cell, came)
        move = choose(colony, own.choice, ant, cell, came)
        if is_allowed(colony.allowed[cell], move):
            raw.moves[ant, steps] = move
            raw.steps[ant] += 1
            raw.straight[ant] += 1 - (move & 1)
            cell += colony.offsets[move]
            touch(colony, cell)
        elif steps > 0 and leaves(move, steps_back):
            given_up.cells[ant, given_up.number[ant]] = cell
            given_up.number[ant] += 1
            raw.steps[ant] -= 1
            raw.straight[ant] -= 1 - (came & 1)
            cell -= colony.offsets[came]
        else:
            crowd.walks[ant] = False
            return LOST <= move <= BACK
        crowd.cell[ant] = cell
        limit = min(colony.max_steps - 2 * given_up.number[ant], raw.moves.shape[1])
        crowd.walks[ant] = cell != colony.goal and raw.steps[ant] < limit
        return True

    @compiled
    def walk_together(room: Any) -> bool:
        colony, crowd, raw, given_up = room.colony, room.crowd, room.raw, room.given_up
        for ant in range(colony.ants):
            crowd.cell[ant], crowd.walks[ant] = colony.start, True
            given_up.number[ant] = 0
            touch(_as_seen_by(colony, crowd, ant), colony.start)
            measure(raw, ant, 0, 0)
        sound = walking = True
        while walking:
            walking = False
            for ant in range(colony.ants):
                if crowd.walks[ant]:
                    sound &= step(_as_seen_by(colony, crowd, ant), room, ant)
                    walking |= crowd.walks[ant]
        for ant in range(colony.ants):
            measure(raw, ant, raw.steps[ant], raw.straight[ant])
            room.made[ant] = raw.steps[ant] + 2 * given_up.number[ant]
            if crowd.cell[ant] != colony.goal:
                raw.length[ant] = np.inf
            forget(_as_seen_by(colony, crowd, ant), raw, ant, given_up.cells[ant], given_up.number[ant])
        return sound

    return walk_together, idle


@compiled
def _as_seen_by(colony: Any, crowd: Any, ant: Any) -> Any:
    """Return the colony with the tabu of one ant of a crowd."""
    return Colony(*(*colony[:-1], crowd.untouched[ant]))
