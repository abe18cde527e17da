"""Changes: what is brought up to date when pheromone changes, and where it has changed since the trial began.

Each edge has a weight, stored^alpha * eta^beta, recomputed when its pheromone changes and not at each step. Paths
share edges, so while an update lays pheromone weights wait, and are recomputed once and not per ant.

Where pheromone has changed is known to the patch, the edges of eight cells in a row. What is done to all pheromone
alike, for a new trial or to keep it within limits, passes over the others; so on a large map it costs what was
touched, and not what there is.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled

PATCH = 64
"""Edges of a patch."""

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


def patches(edges: int) -> int:
    """Return into how many patches so many edges fall."""
    return -(-edges // PATCH)


@compiled
def note_change(colony: Any, edge: Any) -> None:
    """Note that the pheromone on an edge, or on another of the same cell, changes."""
    patch = np.uintp(edge) // np.uintp(PATCH)
    if not colony.is_changed[patch]:  # a load that is foreseen costs less than a store
        colony.is_changed[patch] = 1
        colony.changed[colony.changed_count[0]] = patch
        colony.changed_count[0] += 1


@compiled
def past_edge(colony: Any, patch: Any) -> Any:
    """Return the first edge after those of a patch."""
    return min(patch * PATCH + PATCH, colony.stored.size)


@compiled
def forget_change(colony: Any, place: Any) -> None:
    """Take a patch, by its place among the changed ones, for one that is not; the last takes its place."""
    colony.is_changed[colony.changed[place]] = 0
    colony.changed_count[0] -= 1
    colony.changed[place] = colony.changed[colony.changed_count[0]]


@compiled
def forget_changes(colony: Any) -> None:
    """Take all patches for such that are not changed."""
    colony.is_changed[:] = 0
    colony.changed_count[0] = 0
