"""Tabu: an ant never goes where it has been."""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.changes import note_change
from acoexp.colony.compiled import compiled


@compiled
def touch(colony: Any, cell: Any) -> None:
    """Make a cell tabu for the ant that is walking."""
    colony.untouched[np.uintp(cell)] = 0.0


@compiled
def is_open(colony: Any, cell: Any, direction: Any) -> Any:
    """Tell whether the ant may make this move: it is allowed, and leads where the ant has not been."""
    allowed = colony.allowed[cell] >> direction & 1 == 1
    return allowed and colony.untouched[cell + colony.offsets[direction]] != 0.0


@compiled
def forget(colony: Any, trails: Any, ant: Any, given_up: Any, count: Any) -> None:
    """Lift the tabu from all cells of an ant's walk, and from so many that it gave up, for the next ant.

    And note what it may have changed on its way.
    """
    for place in range(count):
        _leave(colony, given_up[place])
    cell = colony.start
    _leave(colony, cell)
    for step in range(trails.steps[ant]):
        cell += colony.offsets[np.uintp(trails.moves[np.uintp(ant), np.uintp(step)])]
        _leave(colony, cell)


@compiled
def _leave(colony: Any, cell: Any) -> None:
    colony.untouched[np.uintp(cell)] = 1.0
    note_change(colony, cell * 8)
