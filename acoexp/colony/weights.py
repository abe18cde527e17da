"""Weights: stored^alpha * eta^beta on every edge, computed when its pheromone changes and not at each step.

Paths share edges, so while an update lays pheromone weights wait, and are recomputed once and not per ant.
"""

from __future__ import annotations

from typing import Any

from acoexp.colony.compiled import compiled
from acoexp.colony.patches import note_change

SMALLEST_EXACT = 1e-280
"""A weight below it has lost digits, so what is multiplied further is recomputed."""

_WAITS = -1.0


@compiled
def weigh(colony: Any, edge: Any) -> None:
    """Recompute an edge's weight."""
    colony.weight[edge] = colony.stored[edge] ** colony.alpha * colony.desirability[edge]


@compiled
def weigh_all(colony: Any) -> None:
    """Recompute every weight; most edges of a map are alike, so most powers are the one before."""
    last, power = -1.0, 0.0
    for edge in range(colony.stored.size):
        if colony.stored[edge] != last:
            last = colony.stored[edge]
            power = last**colony.alpha
        colony.weight[edge] = power * colony.desirability[edge]
    colony.stale_count[0] = 0


@compiled
def waits(colony: Any, edge: Any) -> Any:
    """Tell whether an edge's weight waits to be recomputed."""
    return colony.weight[edge] < 0.0


@compiled
def let_wait(colony: Any, edge: Any) -> None:
    """Mark an edge's weight as out of date; where too many wait already, recompute it at once."""
    if waits(colony, edge):
        return
    note_change(colony, edge)
    waiting = colony.stale_count[0]
    if waiting < colony.stale.size:
        colony.weight[edge] = _WAITS
        colony.stale[waiting] = edge
        colony.stale_count[0] = waiting + 1
    else:
        weigh(colony, edge)


@compiled
def refresh(colony: Any) -> None:
    """Recompute the weights that wait for it."""
    for i in range(colony.stale_count[0]):
        weigh(colony, colony.stale[i])
    colony.stale_count[0] = 0
