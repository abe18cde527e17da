"""Pheromone: a level on every edge, and the few ways to change it.

All edges evaporate alike, so evaporation is one factor, ``scale``, and costs nothing per edge; the roulette
does not see a common factor. Each edge's weight, stored^alpha * eta^beta, is recomputed when that edge's
pheromone changes and not at every step. Nobody outside this file knows either.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.compiled import compiled

_SMALLEST_SCALE = 1e-100
_SATURATED = 1e300
_HIGHEST_POWER = 1e100
_WAITS = -1.0


@compiled
def level(colony: Any, edge: Any) -> Any:
    """Return the pheromone on an edge."""
    return colony.stored[edge] * colony.scale[0]


@compiled
def deposit(colony: Any, edge: Any, amount: Any) -> None:
    """Add pheromone to an edge."""
    store(colony, edge, colony.stored[edge] + amount / colony.scale[0])


@compiled
def set_level(colony: Any, edge: Any, amount: Any) -> None:
    """Give an edge this level of pheromone."""
    store(colony, edge, amount / colony.scale[0])


@compiled
def multiply(colony: Any, edge: Any, factor: Any, factor_to_alpha: Any) -> None:
    """Multiply the pheromone on an edge; the caller knows factor^alpha, so nothing is recomputed.

    Pheromone saturates before it, or the weight that follows from it, overflows.
    """
    stored = colony.stored[np.uintp(edge)] * factor
    weight = colony.weight[np.uintp(edge)] * factor_to_alpha
    if stored < _SATURATED and weight < _SATURATED:
        colony.stored[np.uintp(edge)] = stored
        colony.weight[np.uintp(edge)] = weight


@compiled
def evaporate(colony: Any, rho: Any) -> None:
    """Let the share ``rho`` of all pheromone evaporate."""
    colony.scale[0] *= 1.0 - rho
    if colony.scale[0] < _SMALLEST_SCALE:
        _fold(colony)


@compiled
def clamp(colony: Any, lowest: Any, highest: Any) -> None:
    """Bring the pheromone of every edge into [lowest, highest]."""
    low, high = lowest / colony.scale[0], highest / colony.scale[0]
    for edge in range(colony.stored.size):
        if colony.stored[edge] < low:
            store(colony, edge, low)
        elif colony.stored[edge] > high:
            store(colony, edge, high)


@compiled
def lay(colony: Any, trails: Any, ant: Any, amount: Any) -> None:
    """Add pheromone to every edge of an ant's path; for updates, whose weights are brought up to date after."""
    share = amount / colony.scale[0]
    cell = colony.start
    for step in range(trails.steps[ant]):
        move = trails.moves[ant, step]
        edge = cell * 8 + move
        colony.stored[edge] = min(colony.stored[edge] + share, _SATURATED)
        _let_wait(colony, edge)
        cell += colony.offsets[move]


@compiled
def reset(colony: Any, initial: Any) -> None:
    """Give every edge its initial pheromone: float64[edges], or float64[1] for one level everywhere."""
    colony.scale[0] = 1.0
    colony.stale_count[0] = 0
    last, power = -1.0, 0.0
    for edge in range(colony.stored.size):
        stored = initial[edge] if initial.size > 1 else initial[0]
        if stored != last:
            last, power = stored, _to_alpha(colony, stored)
        colony.stored[edge] = stored
        colony.weight[edge] = power * colony.desirability[edge]


@compiled
def refresh(colony: Any) -> None:
    """Recompute the weights that wait for it."""
    for i in range(colony.stale_count[0]):
        _weigh(colony, colony.stale[i])
    colony.stale_count[0] = 0


@compiled
def store(colony: Any, edge: Any, stored: Any) -> None:
    """Set an edge's stored value and its weight, unless that waits for an update's end anyway."""
    colony.stored[edge] = min(stored, _SATURATED)
    if colony.weight[edge] >= 0.0:
        _weigh(colony, edge)


@compiled
def _weigh(colony: Any, edge: Any) -> None:
    colony.weight[edge] = _to_alpha(colony, colony.stored[edge]) * colony.desirability[edge]


@compiled
def _to_alpha(colony: Any, stored: Any) -> Any:
    """Return stored^alpha, kept so low that no weight, and no sum of eight, overflows (see DESIRABILITY_LIMIT)."""
    return min(stored**colony.alpha, _HIGHEST_POWER)


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
def _fold(colony: Any) -> None:
    """Multiply the factor into every edge before it underflows."""
    refresh(colony)
    for edge in range(colony.stored.size):
        colony.stored[edge] *= colony.scale[0]
        _weigh(colony, edge)
    colony.scale[0] = 1.0
