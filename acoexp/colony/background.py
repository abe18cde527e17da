"""The background: what is stored on every edge whose pheromone no part has changed.

On a large map that is nearly every edge. What is done to all pheromone alike is done to the background as one
number, and one by one to the edges of changed patches alone.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.changes import (
    PATCH,
    SMALLEST_EXACT,
    forget_change,
    forget_changes,
    past_edge,
    waits,
    weigh,
    weigh_all,
)
from acoexp.colony.compiled import compiled

NONE = -1.0
"""The background where there is none, as levels differ from edge to edge: no edge has it."""


@compiled
def reset(colony: Any, initial: Any) -> None:
    """Give every edge its initial pheromone: float64[edges], or float64[1] for one level everywhere."""
    highest = highest_of(initial)
    colony.scale[0] = highest if highest > 0.0 else 1.0
    if initial.size == 1 and highest > 0.0:
        spread(colony, initial[0] / colony.scale[0])
    else:
        for edge in range(colony.stored.size):
            colony.stored[edge] = initial[edge % initial.size] / colony.scale[0]
        without(colony)


@compiled
def spread(colony: Any, stored: Any) -> None:
    """Store one value, greater than 0, on every edge, and bring the weights up to date."""
    power = stored**colony.alpha
    if colony.background[0] == stored:
        while colony.changed_count[0] > 0:
            patch = np.int64(colony.changed[0])
            _store(colony, patch * PATCH, past_edge(colony, patch), stored, power)
            forget_change(colony, 0)
    else:
        _store(colony, 0, colony.stored.size, stored, power)
        colony.background[0] = stored
        forget_changes(colony)
    colony.stale_count[0] = 0


@compiled
def _store(colony: Any, first: Any, past: Any, stored: Any, power: Any) -> None:
    for edge in range(first, past):
        colony.stored[edge] = stored
        colony.weight[edge] = power * colony.desirability[edge]


@compiled
def without(colony: Any) -> None:
    """Have no background, and bring the weights up to date with what is stored now."""
    colony.background[0] = NONE
    weigh_all(colony)


@compiled
def into_bounds(level: Any, lowest: Any, highest: Any) -> Any:
    """Return a level, or the bound that it is beyond."""
    if level < lowest:
        return lowest
    return highest if level > highest else level


@compiled
def clamp_changed(colony: Any, lowest: Any, highest: Any, scale: Any) -> None:
    """Go over to another scale, and bring all levels but the background's into [lowest, highest].

    What is stored as the background stays as it is, so its level follows the scale; all others keep theirs.
    """
    former, power = colony.scale[0], colony.background[0] ** colony.alpha
    growth = former / scale
    growth_to_alpha = growth**colony.alpha
    colony.scale[0] = scale
    place = 0
    while place < colony.changed_count[0]:
        patch = np.int64(colony.changed[place])
        first, past = patch * PATCH, past_edge(colony, patch)
        if not _differs(colony, first, past):
            _store(colony, first, past, colony.background[0], power)
            forget_change(colony, place)
            continue
        place += 1
        if scale != former or _would_change(colony, first, past, lowest, highest):
            for edge in range(first, past):
                if colony.stored[edge] != colony.background[0]:
                    _clamp(colony, edge, lowest, highest, former, growth, growth_to_alpha)


@compiled
def _differs(colony: Any, first: Any, past: Any) -> Any:
    """Tell whether what is stored on any of some edges is not the background; without a branch for each."""
    background, differs = colony.background[0], False
    for edge in range(np.uintp(first), np.uintp(past)):
        differs |= colony.stored[edge] != background
    return differs


@compiled
def _would_change(colony: Any, first: Any, past: Any, lowest: Any, highest: Any) -> Any:
    """Tell whether any of some edges would be changed, the scale being the same; without a branch for each."""
    background, scale, found = colony.background[0], colony.scale[0], False
    for edge in range(np.uintp(first), np.uintp(past)):
        level, weight = colony.stored[edge] * scale, colony.weight[edge]
        changes = (level < lowest) | (level > highest) | (weight < SMALLEST_EXACT) | (weight == np.inf)
        found |= changes & (colony.stored[edge] != background)
    return found


@compiled
def _clamp(
    colony: Any, edge: Any, lowest: Any, highest: Any, former: Any, growth: Any, growth_to_alpha: Any
) -> None:
    """Bring the level of an edge, until now of the former scale, into the limits."""
    before = colony.stored[edge] * former
    after = into_bounds(before, lowest, highest)
    if after == before and SMALLEST_EXACT <= colony.weight[edge] * growth_to_alpha < np.inf:
        colony.stored[edge] *= growth
        colony.weight[edge] *= growth_to_alpha
        return
    at_background = after == colony.background[0] * colony.scale[0]
    colony.stored[edge] = colony.background[0] if at_background else after / colony.scale[0]
    if not waits(colony, edge):
        weigh(colony, edge)


@compiled
def highest_of(values: Any) -> Any:
    """Return the highest of some values, 0 if none is above it."""
    highest = 0.0
    for i in range(values.size):
        highest = max(highest, values[i])
    return highest
