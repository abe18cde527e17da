"""Tabu: an ant never goes where it has been."""

from __future__ import annotations

from typing import Any

import numpy as np

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
def forget(colony: Any, trails: Any, ant: Any) -> None:
    """Lift the tabu from all cells of an ant's walk, for the next ant."""
    cell = colony.start
    colony.untouched[cell] = 1.0
    for step in range(trails.steps[ant]):
        cell += colony.offsets[np.uintp(trails.moves[np.uintp(ant), np.uintp(step)])]
        colony.untouched[np.uintp(cell)] = 1.0
