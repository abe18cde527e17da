"""Patches: where pheromone has been changed since the trial began, to the nearest eight cells.

What is done to all pheromone alike, for a new trial or to keep it within limits, passes over the other patches; so
on a large map it costs what was touched, and not what there is.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled

PATCH = 64
"""Edges of a patch: those of eight cells in a row."""


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
