"""The workspace: the memory of one worker, used for one trial after the other."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.loop import Own, Record
from acoexp.colony.problem import Problem
from acoexp.colony.state import Colony, Trails, new_colony, new_trails
from acoexp.colony.walk import ORDERS, Crowd, new_crowd
from acoexp.errors import SettingsError
from acoexp.preparation import Prepared


class Workspace(NamedTuple):
    """What a trial works on.

    Attributes:
        crowd: The ants, where they walk together.
        to_restore: Arrays of ``own`` that kernels may write to, each with what it is before a trial.
    """

    colony: Colony
    crowd: Crowd | None
    own: Own
    to_restore: list[tuple[NDArray[Any], NDArray[Any]]]
    raw: Trails
    final: Trails
    best: Trails
    cells: NDArray[np.int32]


def new_workspace(
    problem: Problem, prepared: Prepared, order: Any, has_post: bool, stop: NDArray[np.uint8]
) -> Workspace:
    """Make a workspace.

    Args:
        problem: What is solved.
        prepared: What the parts have prepared for it.
        order: How the ants of a cycle walk, one of ``ORDERS``.
        has_post: Whether paths are optimised.
        stop: uint8[1], not 0 when the trial is to end early.

    Raises:
        SettingsError: if the memory does not suffice for so many ants.
    """
    ants, cells = problem.settings.ants, prepared.desirability.size // 8
    try:
        raw = new_trails(ants, cells)
        own = Own(*(_copied(state) for state in prepared.own))
        return Workspace(
            colony=new_colony(problem, prepared.desirability, stop),
            crowd=new_crowd(ants, cells) if order is ORDERS["lock_step"] else None,
            own=own,
            to_restore=list(zip(_writable(own), _writable(prepared.own), strict=True)),
            raw=raw,
            final=new_trails(ants, cells) if has_post else raw,
            best=new_trails(2, cells),
            cells=np.empty(cells if has_post else 1, dtype=np.int32),
        )
    except MemoryError as problem_of_size:
        raise SettingsError(
            f"ants: expected a number for which the memory suffices; got {ants} on a map of {cells} cells"
        ) from problem_of_size


def new_record(iterations: int) -> Record:
    """Return the record of a trial of so many cycles, to be filled."""
    pairs, lost = np.empty((iterations, 2), dtype=np.int32), np.empty(iterations, dtype=np.int32)
    return Record(pairs, lost, np.zeros(1, dtype=np.int64))


def _copied(state: Any) -> Any:
    """Return a part's own state with copies of the arrays that it may write to."""
    values = (v.copy() if isinstance(v, np.ndarray) and v.flags.writeable else v for v in state)
    return type(state)(*values) if hasattr(state, "_fields") else tuple(values)


def _writable(own: Own) -> list[NDArray[Any]]:
    """Return the arrays of the parts' own states that kernels may write to."""
    values = (value for state in own for value in state)
    return [value for value in values if isinstance(value, np.ndarray) and value.flags.writeable]
