"""The workspace: the memory of one worker, used for one trial after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.background import NONE
from acoexp.colony.changes import patches
from acoexp.colony.pheromone import HIGHEST_POWER
from acoexp.colony.problem import Problem
from acoexp.colony.state import (
    Colony,
    Crowd,
    Facing,
    GivenUp,
    Own,
    Pair,
    Prepared,
    Record,
    Room,
    Trails,
)
from acoexp.errors import SettingsError
from acoexp.grid.moves import DIRECTIONS

STALE_EDGES = 4096
"""Edges whose weight may wait to be recomputed until an update is over."""


class Workspace(NamedTuple):
    """What a worker's trials work on, and what has to be restored before each of them.

    Attributes:
        room: What the loop works on.
        to_restore: Arrays of ``room.own`` that kernels may write to, each with what it is before a trial.
    """

    room: Room
    to_restore: list[tuple[NDArray[Any], NDArray[Any]]]


class End(NamedTuple):
    """What ants of one end set out with.

    Attributes:
        problem: Their way: from their end to the other.
        prepared: What the parts have prepared for it.
    """

    problem: Problem
    prepared: Prepared


def new_workspace(ends: Sequence[End], has_post: bool, stop: NDArray[np.uint8]) -> Workspace:
    """Make a workspace.

    Args:
        ends: The end at the start; and the one at the goal, if ants set out from there, too.
        has_post: Whether paths are optimised.
        stop: uint8[1], not 0 when the trial is to end early.

    Raises:
        SettingsError: if the memory does not suffice for so many ants.
    """
    (problem, prepared), *at_goal = ends
    try:
        room = _new_room(problem, prepared, has_post, stop)
        if at_goal:
            room = room._replace(facing=_new_facing(at_goal[0], room.colony, has_post))
    except MemoryError as problem_of_size:
        ants, cells = problem.settings.ants, prepared.desirability.size // 8
        raise SettingsError(
            f"ants: expected a number for which the memory suffices; got {ants} on a map of {cells} cells"
        ) from problem_of_size
    owns = [room.own, *(() if room.facing is None else (room.facing.own,))]
    to_restore = [
        pair
        for own, end in zip(owns, ends, strict=True)
        for pair in zip(_writable(own), _writable(end.prepared.own), strict=True)
    ]
    return Workspace(room, to_restore)


def _new_room(problem: Problem, prepared: Prepared, has_post: bool, stop: NDArray[np.uint8]) -> Room:
    ants, cells = problem.settings.ants, prepared.desirability.size // 8
    raw, at_once = new_trails(ants, cells), {"lock_step": ants, "two_ended": 2}.get(problem.settings.order, 1)
    return Room(
        colony=new_colony(problem, prepared.desirability, stop),
        crowd=new_crowd(ants, cells) if problem.settings.order == "lock_step" else None,
        facing=None,
        given_up=new_given_up(at_once, cells),
        made=np.zeros(ants, dtype=np.int64),
        own=_copied(prepared.own),
        initial=prepared.initial,
        raw=raw,
        final=new_trails(ants, cells) if has_post else raw,
        best=new_trails(2, cells),
        cells=np.empty(cells if has_post else 1, dtype=np.int32),
    )


def _new_facing(end: End, other: Colony, has_post: bool) -> Facing:
    """Return the colony at the goal, which shares with the other what is the trial's and not an end's."""
    ants, cells = other.ants, other.allowed.size
    shared = {name: getattr(other, name) for name in ("cycle", "random", "unsound")}
    raw = new_trails(ants, cells)
    return Facing(
        colony=new_colony(end.problem, end.prepared.desirability, other.stop)._replace(**shared),
        pair=Pair(np.zeros(2, dtype=np.int64), np.zeros(2, dtype=np.bool_), np.full((2, cells), -1, np.int32)),
        own=_copied(end.prepared.own),
        initial=end.prepared.initial,
        raw=raw,
        final=new_trails(ants, cells) if has_post else raw,
        best=new_trails(2, cells),
    )


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
        patience=min(settings.iterations, settings.patience or settings.iterations),
        max_steps=min(2 * cells, settings.max_steps or 2 * cells),  # to each cell and back
        highest_stored=HIGHEST_POWER ** (1.0 / max(settings.alpha, 1.0)),
        stored=np.empty(cells * 8),
        scale=np.ones(1),
        weight=np.empty(cells * 8),
        stale=np.empty(min(STALE_EDGES, cells * 8), dtype=np.int32),
        stale_count=np.zeros(1, dtype=np.int64),
        background=np.array([NONE]),
        changed=np.empty(patches(cells * 8), dtype=np.int32),
        changed_count=np.zeros(1, dtype=np.int64),
        is_changed=np.zeros(patches(cells * 8), dtype=np.uint8),
        cycle=np.zeros(1, dtype=np.int64),
        random=np.zeros(4, dtype=np.uint64),
        unsound=np.zeros(1, dtype=np.uint8),
        stop=stop,
        on_cells=True if settings.pheromone == "cells" else None,
        untouched=np.ones(cells),
    )


def new_crowd(ants: int, cells: int) -> Crowd:
    """Return so many ants on a map of so many cells (border included)."""
    return Crowd(
        np.zeros(ants, dtype=np.int64), np.zeros(ants, dtype=np.bool_), np.ones((ants, cells), dtype=np.float64)
    )


def new_given_up(at_once: int, cells: int) -> GivenUp:
    """Return room for what ants step back from, so many that walk at once, on a map of so many cells."""
    return GivenUp(np.empty((at_once, cells), dtype=np.int32), np.zeros(at_once, dtype=np.int64))


def new_record(iterations: int) -> Record:
    """Return the record of a trial of so many cycles, to be filled."""
    pairs, lost = np.empty((iterations, 2), dtype=np.int32), np.empty(iterations, dtype=np.int32)
    return Record(pairs, lost, np.zeros(iterations, dtype=np.int64))


def _copied(own: Own) -> Own:
    """Return the parts' own states with copies of the arrays that they may write to."""
    return Own(*map(_copied_state, own))


def _copied_state(state: Any) -> Any:
    values = (v.copy() if isinstance(v, np.ndarray) and v.flags.writeable else v for v in state)
    return type(state)(*values) if hasattr(state, "_fields") else tuple(values)


def _writable(own: Own) -> list[NDArray[Any]]:
    """Return the arrays of the parts' own states that kernels may write to."""
    values = (value for state in own for value in state)
    return [value for value in values if isinstance(value, np.ndarray) and value.flags.writeable]
