"""Trails: paths as directions, one byte a step, and as cells while a post-optimiser works on them."""

from __future__ import annotations

from typing import Any

from acoexp.colony.compiled import compiled
from acoexp.grid.moves import SQRT2


@compiled
def measure(trails: Any, ant: Any, steps: Any, straight: Any) -> None:
    """Note down how many moves an ant made, and the length that follows."""
    trails.steps[ant] = steps
    trails.straight[ant] = straight
    trails.length[ant] = straight + (steps - straight) * SQRT2


@compiled
def read_cells(colony: Any, trails: Any, ant: Any, cells: Any) -> Any:
    """Write an ant's path into ``cells`` (int32[]) and return how many cells it has, both ends included."""
    cell = colony.start
    cells[0] = cell
    for step in range(trails.steps[ant]):
        cell += colony.offsets[trails.moves[ant, step]]
        cells[step + 1] = cell
    return trails.steps[ant] + 1


@compiled
def write_cells(colony: Any, cells: Any, count: Any, trails: Any, ant: Any) -> Any:
    """Take a path given as cells over into ``trails``; return False if it is not a path from start to goal."""
    if not 2 <= count <= cells.size or cells[0] != colony.start or cells[count - 1] != colony.goal:
        return False
    straight = 0
    for step in range(count - 1):
        cell = cells[step]
        jump = cells[step + 1] - cell + colony.width + 1
        if not 0 <= jump < colony.direction_of.size:
            return False
        move = colony.direction_of[jump]
        if not colony.allowed[cell] >> move & 1:
            return False
        trails.moves[ant, step] = move
        straight += 1 - (move & 1)
    measure(trails, ant, count - 1, straight)
    return True


@compiled
def leads_to_goal(colony: Any, trails: Any, row: Any) -> Any:
    """Tell whether a trail is made of allowed moves and ends at the goal."""
    cell = colony.start
    for step in range(trails.steps[row]):
        move = trails.moves[row, step]
        if not colony.allowed[cell] >> move & 1:
            return False
        cell += colony.offsets[move]
    return cell == colony.goal


@compiled
def copy_trail(source: Any, ant: Any, target: Any, row: Any) -> None:
    """Copy one ant's path into a row of other trails."""
    steps = source.steps[ant]
    for step in range(steps):
        target.moves[row, step] = source.moves[ant, step]
    target.steps[row] = steps
    target.straight[row] = source.straight[ant]
    target.length[row] = source.length[ant]
