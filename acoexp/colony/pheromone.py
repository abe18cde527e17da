"""Pheromone: a level on every edge, and the few ways to change it.

Where pheromone lies on cells, all edges into a cell have its level: whatever changes one changes the others too,
and a part need not know.

All edges evaporate alike, so evaporation is one factor, ``scale``, and costs nothing per edge; the roulette
does not see a common factor. Each edge's weight, stored^alpha * eta^beta, is recomputed when that edge's
pheromone changes and not at every step. Only levels relative to each other count, so what is stored is brought
back to at most 1 before it, or a weight, could overflow. The factor stays between 10^-150 and 10^150: further
evaporation, or growth, of all pheromone together changes nothing that an ant could see.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from acoexp.colony.background import clamp_changed, highest_of, into_bounds, without
from acoexp.colony.changes import SMALLEST_EXACT, let_wait, note_change, waits, weigh, weigh_all
from acoexp.colony.compiled import compiled

HIGHEST_POWER = 1e90
"""Bound of stored^alpha."""

_SMALLEST_SCALE = 1e-150
_HIGHEST_SCALE = 1e150


@compiled
def level(colony: Any, edge: Any) -> Any:
    """Return the pheromone on an edge."""
    return colony.stored[edge] * colony.scale[0]


@compiled
def deposit(colony: Any, edge: Any, amount: Any) -> None:
    """Add pheromone to an edge."""
    note_change(colony, edge)
    _store(colony, edge, colony.stored[edge] + amount / colony.scale[0])
    _share(colony, edge, False)


@compiled
def set_level(colony: Any, edge: Any, amount: Any) -> None:
    """Give an edge this level of pheromone."""
    note_change(colony, edge)
    _store(colony, edge, amount / colony.scale[0])
    _share(colony, edge, False)


@compiled
def multiply(colony: Any, edge: Any, factor: Any, factor_to_alpha: Any) -> None:
    """Multiply the pheromone on an edge; the caller knows factor^alpha, so nothing is recomputed."""
    note_change(colony, edge)
    multiply_here(colony, edge, factor, factor_to_alpha)


@compiled
def multiply_here(colony: Any, edge: Any, factor: Any, factor_to_alpha: Any) -> None:
    """Multiply the pheromone on an edge from the cell of the ant that is walking: a little quicker."""
    stored = colony.stored[np.uintp(edge)] * factor
    weight = colony.weight[np.uintp(edge)] * factor_to_alpha
    if stored <= colony.highest_stored and weight >= SMALLEST_EXACT:
        colony.stored[np.uintp(edge)] = stored
        colony.weight[np.uintp(edge)] = weight
    else:
        _store(colony, edge, stored)
    _share(colony, edge, False)


@compiled
def multiply_one(colony: Any, cell: Any, direction: Any, factor: Any, to_alpha: Any) -> None:
    """Multiply the pheromone on one edge from the cell of the ant that is walking, on none if the direction is 8.

    A choice reads all eight weights, and would wait for one that was just written. So all are written, at places
    that the compiler knows, and it keeps them at hand.

    Args:
        colony: The colony.
        cell, direction: The edge; its pheromone is multiplied by ``factor``.
        factor: At least 0.
        to_alpha: float64[9, 8]: row d has factor^alpha at d, and 1 elsewhere.
    """
    row = np.uintp(direction)
    if direction < 8:
        edge = np.uintp(cell * 8 + direction)
        stored = colony.stored[edge] * factor
        if stored <= colony.highest_stored and colony.weight[edge] * to_alpha[row, row] >= SMALLEST_EXACT:
            colony.stored[edge] = stored
        else:
            _store(colony, edge, stored)
            row = np.uintp(8)
    for other in range(8):
        colony.weight[np.uintp(cell * 8 + other)] *= to_alpha[row, np.uintp(other)]
    if direction < 8:
        _share(colony, cell * 8 + direction, False)


@compiled
def evaporate(colony: Any, rho: Any) -> None:
    """Let the share ``rho`` of all pheromone evaporate."""
    if rho == 1.0:
        _clear(colony)
    else:
        colony.scale[0] = max(colony.scale[0] * (1.0 - rho), _SMALLEST_SCALE)


@compiled
def clamp(colony: Any, lowest: Any, highest: Any) -> None:
    """Bring the pheromone of every edge into [lowest, highest]."""
    if colony.background[0] > 0.0:
        there = colony.background[0] * colony.scale[0]
        bounded = into_bounds(there, lowest, highest)
        scale = colony.scale[0] if bounded == there else bounded / colony.background[0]
        if _SMALLEST_SCALE <= scale <= _HIGHEST_SCALE and highest <= colony.highest_stored * scale:
            clamp_changed(colony, lowest, highest, scale)
            return
    for edge in range(colony.stored.size):
        tau = level(colony, edge)
        if into_bounds(tau, lowest, highest) != tau:
            set_level(colony, edge, into_bounds(tau, lowest, highest))


@compiled
def lay(colony: Any, trails: Any, ant: Any, amount: Any) -> None:
    """Add pheromone to every edge of an ant's path; for updates, whose weights are brought up to date after."""
    if amount / colony.scale[0] > colony.highest_stored:
        _raise_scale(colony, amount)
    if not amount >= 0.0:
        colony.unsound[0] = 1
    share = amount / colony.scale[0]
    cell = colony.start
    for step in range(trails.steps[ant]):
        move = trails.moves[np.uintp(ant), np.uintp(step)]
        edge = np.uintp(cell * 8 + move)
        stored = colony.stored[edge] + share
        colony.stored[edge] = stored
        _share(colony, edge, True)
        if stored <= colony.highest_stored:
            let_wait(colony, edge)
        else:
            note_change(colony, edge)
            _normalise(colony)
            share = amount / colony.scale[0]
        cell += colony.offsets[np.uintp(move)]


@compiled
def _store(colony: Any, edge: Any, stored: Any) -> None:
    """Set an edge's stored value and its weight, unless that waits for an update's end anyway."""
    if not stored >= 0.0:
        colony.unsound[0] = 1
    if stored > colony.highest_stored:
        amount = min(stored * colony.scale[0], _HIGHEST_SCALE)
        _raise_scale(colony, amount)
        stored = amount / colony.scale[0]
    colony.stored[edge] = stored
    if not waits(colony, edge):
        weigh(colony, edge)


@compiled
def _share(colony: Any, edge: Any, later: Any) -> None:
    """Where pheromone lies on cells, give all edges into the cell that an edge leads to what is stored on it."""
    if colony.on_cells is None:
        return
    cell, direction = np.int64(edge) // 8, np.int64(edge) % 8
    if not colony.allowed[cell] >> direction & 1:
        return
    stored = colony.stored[edge]
    power = stored**colony.alpha
    target = cell + colony.offsets[direction]
    for back in range(8):
        if colony.allowed[target] >> back & 1:
            other = (target + colony.offsets[back]) * 8 + (back ^ 4)
            colony.stored[other] = stored
            if later:
                let_wait(colony, other)
            elif not waits(colony, other):
                note_change(colony, other)
                colony.weight[other] = power * colony.desirability[other]


@compiled
def _normalise(colony: Any) -> None:
    """Bring what is stored to at most 1, all levels staying as they are."""
    _rescale(colony, highest_of(colony.stored))


@compiled
def _raise_scale(colony: Any, amount: Any) -> None:
    """Make room for an amount that would overflow: scale such that it is stored as 1."""
    _rescale(colony, max(amount / colony.scale[0], highest_of(colony.stored)))


@compiled
def _rescale(colony: Any, factor: Any) -> None:
    """Divide what is stored by a factor, and multiply the scale by it."""
    for edge in range(colony.stored.size):
        colony.stored[edge] /= factor
    colony.background[0] /= factor
    colony.scale[0] = min(colony.scale[0] * factor, _HIGHEST_SCALE)
    weigh_all(colony)


@compiled
def _clear(colony: Any) -> None:
    """Let all pheromone be gone."""
    for edge in range(colony.stored.size):
        colony.stored[edge] = 0.0
    colony.scale[0] = 1.0
    without(colony)
