"""Steps: what a choice's answer comes to, whatever the order in which ants walk."""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.state import BACK, LOST, NO_WAY_HERE


@compiled
def idle(*_: Any) -> bool:
    """Do nothing, with success: stands where a colony has no use for a kernel, and costs nothing."""
    return True


@compiled
def is_allowed(allowed: Any, move: Any) -> Any:
    """Tell whether a move is among the allowed ones; a number that is no direction is not."""
    return 0 <= move < 8 and allowed >> np.uint8(move) & 1


@compiled
def leaves(move: Any, steps_back: Any) -> Any:
    """Tell whether an ant gives its last move back."""
    return move == BACK or (steps_back and move == LOST)


@compiled
def came_by(raw: Any, ant: Any, steps: Any) -> Any:
    """Return the direction of an ant's last move, of so many."""
    return np.int64(raw.moves[ant, steps - 1]) if steps > 0 else NO_WAY_HERE
