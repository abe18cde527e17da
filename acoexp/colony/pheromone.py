"""Pheromone: a level on every edge, and the few ways to change it.

All edges evaporate alike, so evaporation is one factor, ``scale``, and costs nothing per edge; the roulette
does not see a common factor. Each edge's weight, stored^alpha * eta^beta, is recomputed when that edge's
pheromone changes and not at every step. Only levels relative to each other count, so what is stored is brought
back to at most 1 before it, or a weight, could overflow; levels themselves saturate at 10^150. Nobody outside
this file knows of any of this.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled

HIGHEST_POWER = 1e90
"""Bound of stored^alpha."""

_SMALLEST_SCALE = 1e-150
_HIGHEST_SHARE = 1e300
_HIGHEST_SCALE = 1e150
_WAITS = -1.0


@compiled
def level(colony: Any, edge: Any) -> Any:
    """Return the pheromone on an edge."""
    return colony.stored[edge] * colony.scale[0]


@compiled
def deposit(colony: Any, edge: Any, amount: Any) -> None:
    """Add pheromone to an edge."""
    _store(colony, edge, colony.stored[edge] + amount / colony.scale[0])


@compiled
def set_level(colony: Any, edge: Any, amount: Any) -> None:
    """Give an edge this level of pheromone."""
    _store(colony, edge, amount / colony.scale[0])


@compiled
def multiply(colony: Any, edge: Any, factor: Any, factor_to_alpha: Any) -> None:
    """Multiply the pheromone on an edge; the caller knows factor^alpha, so nothing is recomputed."""
    stored = colony.stored[np.uintp(edge)] * factor
    if stored <= colony.highest_stored:
        colony.stored[np.uintp(edge)] = stored
        colony.weight[np.uintp(edge)] *= factor_to_alpha
    else:
        _store(colony, edge, stored)


@compiled
def evaporate(colony: Any, rho: Any) -> None:
    """Let the share ``rho`` of all pheromone evaporate."""
    colony.scale[0] *= 1.0 - rho
    if colony.scale[0] < _SMALLEST_SCALE:
        _normalise(colony)


@compiled
def clamp(colony: Any, lowest: Any, highest: Any) -> None:
    """Bring the pheromone of every edge into [lowest, highest]."""
    for edge in range(colony.stored.size):
        tau = level(colony, edge)
        if tau < lowest:
            set_level(colony, edge, lowest)
        elif tau > highest:
            set_level(colony, edge, highest)


@compiled
def lay(colony: Any, trails: Any, ant: Any, amount: Any) -> None:
    """Add pheromone to every edge of an ant's path; for updates, whose weights are brought up to date after."""
    share = min(amount / colony.scale[0], _HIGHEST_SHARE)
    cell = colony.start
    for step in range(trails.steps[ant]):
        move = trails.moves[np.uintp(ant), np.uintp(step)]
        edge = np.uintp(cell * 8 + move)
        stored = colony.stored[edge] + share
        colony.stored[edge] = stored
        if stored <= colony.highest_stored:
            _let_wait(colony, edge)
        else:
            _normalise(colony)
            share = amount / colony.scale[0]
        cell += colony.offsets[np.uintp(move)]


@compiled
def reset(colony: Any, initial: Any) -> None:
    """Give every edge its initial pheromone: float64[edges], or float64[1] for one level everywhere."""
    highest = _highest(initial)
    colony.scale[0] = highest if highest > 0.0 else 1.0
    if initial.size == 1:
        stored = initial[0] / colony.scale[0]
        power = stored**colony.alpha
        for edge in range(colony.stored.size):
            colony.stored[edge] = stored
            colony.weight[edge] = power * colony.desirability[edge]
        colony.stale_count[0] = 0
    else:
        for edge in range(colony.stored.size):
            colony.stored[edge] = initial[edge] / colony.scale[0]
        _weigh_all(colony)


@compiled
def refresh(colony: Any) -> None:
    """Recompute the weights that wait for it."""
    for i in range(colony.stale_count[0]):
        _weigh(colony, colony.stale[i])
    colony.stale_count[0] = 0


@compiled
def _store(colony: Any, edge: Any, stored: Any) -> None:
    """Set an edge's stored value and its weight, unless that waits for an update's end anyway."""
    colony.stored[edge] = min(stored, _HIGHEST_SHARE)
    if stored > colony.highest_stored:
        _normalise(colony)
    elif colony.weight[edge] >= 0.0:
        _weigh(colony, edge)


@compiled
def _weigh(colony: Any, edge: Any) -> None:
    colony.weight[edge] = colony.stored[edge] ** colony.alpha * colony.desirability[edge]


@compiled
def _let_wait(colony: Any, edge: Any) -> None:
    """Mark an edge's weight as out of date; paths share edges, so it is recomputed once and not per ant."""
    if colony.weight[edge] < 0.0:
        return
    waiting = colony.stale_count[0]
    if waiting < colony.stale.size:
        colony.weight[edge] = _WAITS
        colony.stale[waiting] = edge
        colony.stale_count[0] = waiting + 1
    else:
        _weigh(colony, edge)


@compiled
def _normalise(colony: Any) -> None:
    """Bring what is stored to at most 1, all levels staying as they are; levels below any float become 0."""
    highest = _highest(colony.stored)
    if highest == 0.0 or colony.scale[0] == 0.0:
        colony.stored[:] = 0.0
        colony.scale[0] = 1.0
    else:
        for edge in range(colony.stored.size):
            colony.stored[edge] /= highest
        colony.scale[0] = min(colony.scale[0] * highest, _HIGHEST_SCALE)
    _weigh_all(colony)


@compiled
def _highest(values: Any) -> Any:
    highest = 0.0
    for i in range(values.size):
        highest = max(highest, values[i])
    return highest


@compiled
def _weigh_all(colony: Any) -> None:
    """Recompute every weight; most edges of a map are alike, so most powers are the one before."""
    last, power = -1.0, 0.0
    for edge in range(colony.stored.size):
        if colony.stored[edge] != last:
            last = colony.stored[edge]
            power = last**colony.alpha
        colony.weight[edge] = power * colony.desirability[edge]
    colony.stale_count[0] = 0
