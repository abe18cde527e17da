"""Two ends: for each ant that sets out from the start one sets out from the goal; where they meet there is a path.

At each end is a colony with pheromone of its own, and in the one at the goal, ``room.facing``, start and goal have
changed places: a part sees a colony, and need not know which. The ants of a pair make a step each in turn. One
that stands where the other came by on its way has met it. The path goes to both colonies, to the one at the goal
backwards. This is the bidirectional search with a tabu table that Liu et al. 2017 cite (Kang et al. 2014).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.background import reset
from acoexp.colony.changes import refresh
from acoexp.colony.compiled import compiled
from acoexp.colony.state import Kernel
from acoexp.colony.steps import came_by, idle, is_allowed, leaves
from acoexp.colony.tabu import forget, touch
from acoexp.colony.trails import copy_trail, measure

AT_START, AT_GOAL = 0, 1
"""Rows of what a pair remembers."""


def two_ended(choose: Kernel, diffuse: Kernel, steps_back: bool) -> tuple[Kernel, Kernel]:
    """Each pair sets out when the one before has met, or both are lost."""

    @compiled
    def step(room: Any, end: Any, colony: Any, own: Any, raw: Any, ant: Any) -> Any:
        """Let the ant of one end make a move; return False if that is not allowed."""
        pair, given_up = room.facing.pair, room.given_up
        cell, steps, left = pair.cell[end], raw.steps[ant], given_up.number[end]
        came = came_by(raw, ant, steps)
        diffuse(colony, own.diffusion, ant, cell, came)
        move = choose(colony, own.choice, ant, cell, came)
        if is_allowed(colony.allowed[cell], move):
            raw.moves[ant, steps] = move
            raw.steps[ant] += 1
            cell += colony.offsets[move]
            touch(colony, cell)
            pair.place[end, cell] = steps + 1
        elif steps > 0 and leaves(move, steps_back):
            given_up.cells[end, left] = cell
            given_up.number[end] += 1
            pair.place[end, cell] = -1
            raw.steps[ant] -= 1
            cell -= colony.offsets[came]
        else:
            pair.walks[end] = False
            return leaves(move, True)
        pair.cell[end] = cell
        limit = min(colony.max_steps - 2 * given_up.number[end], raw.moves.shape[1])
        pair.walks[end] = raw.steps[ant] < limit
        return True

    @compiled
    def walk(room: Any, ant: Any) -> Any:
        facing = room.facing
        _set_out(room, AT_START, room.colony, room.raw, ant)
        _set_out(room, AT_GOAL, facing.colony, facing.raw, ant)
        sound, meeting = True, -1
        while meeting < 0 and (facing.pair.walks[AT_START] or facing.pair.walks[AT_GOAL]):
            if facing.pair.walks[AT_START]:
                sound &= step(room, AT_START, room.colony, room.own, room.raw, ant)
                meeting = _where_met(facing.pair, AT_START)
            if meeting < 0 and facing.pair.walks[AT_GOAL]:
                sound &= step(room, AT_GOAL, facing.colony, facing.own, facing.raw, ant)
                meeting = _where_met(facing.pair, AT_GOAL)
        here = facing.pair.place[AT_START, meeting] if meeting >= 0 else -1
        there = facing.pair.place[AT_GOAL, meeting] if meeting >= 0 else -1
        room.made[ant] = _come_home(room, AT_START, room.colony, room.raw, ant)
        room.made[ant] += _come_home(room, AT_GOAL, facing.colony, facing.raw, ant)
        if meeting >= 0:
            _join(room.raw, here, facing.raw, there, ant)
        else:
            measure(room.raw, ant, room.raw.steps[ant], 0)
            room.raw.length[ant] = np.inf
        return sound

    return idle, walk


def at_both_ends(update: Kernel) -> tuple[Kernel, Kernel]:
    """Return what begins a trial in the colony at the goal, and what updates it at the end of a cycle."""

    @compiled
    def begin(room: Any) -> None:
        reset(room.facing.colony, room.facing.initial)

    @compiled
    def close(room: Any) -> None:
        facing = room.facing
        for ant in range(room.colony.ants):
            _turn_round(room.raw, facing.raw, ant)
            _turn_round(room.final, facing.final, ant)
        for row in range(2):
            _turn_round(room.best, facing.best, row)
        update(facing.colony, facing.own.update, facing.raw, facing.final, facing.best)
        refresh(facing.colony)

    return begin, close


@compiled
def _set_out(room: Any, end: Any, colony: Any, raw: Any, ant: Any) -> None:
    pair = room.facing.pair
    pair.cell[end], pair.walks[end] = colony.start, True
    pair.place[end, colony.start] = 0
    room.given_up.number[end] = 0
    touch(colony, colony.start)
    measure(raw, ant, 0, 0)


@compiled
def _where_met(pair: Any, end: Any) -> Any:
    """Return the cell that an ant stands on if the other is on it, or came by on its way; else -1."""
    return pair.cell[end] if pair.place[1 - end, pair.cell[end]] >= 0 else -1


@compiled
def _come_home(room: Any, end: Any, colony: Any, raw: Any, ant: Any) -> Any:
    """Lift what is tabu and forget the way; return how many moves the ant had made."""
    given_up, place = room.given_up, room.facing.pair.place
    forget(colony, raw, ant, given_up.cells[end], given_up.number[end])
    cell = colony.start
    place[end, cell] = -1
    for step in range(raw.steps[ant]):
        cell += colony.offsets[raw.moves[ant, step]]
        place[end, cell] = -1
    return raw.steps[ant] + 2 * given_up.number[end]


@compiled
def _join(raw: Any, here: Any, facing: Any, there: Any, ant: Any) -> None:
    """Make one path of so many moves of the ant from the start, and as many of the other's backwards."""
    straight = 0
    for step in range(there):
        raw.moves[ant, here + step] = facing.moves[ant, there - 1 - step] ^ 4
    for step in range(here + there):
        straight += 1 - (raw.moves[ant, step] & 1)
    measure(raw, ant, here + there, straight)


@compiled
def _turn_round(trails: Any, facing: Any, row: Any) -> None:
    """Copy a path from start to goal as one from goal to start; of a lost ant nothing but that it is lost."""
    if trails.length[row] == np.inf:
        facing.length[row] = np.inf
        return
    copy_trail(trails, row, facing, row)
    steps = trails.steps[row]
    for step in range(steps):
        facing.moves[row, step] = trails.moves[row, steps - 1 - step] ^ 4
