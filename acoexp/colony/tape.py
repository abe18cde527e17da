"""Tape: what a trial does cycle by cycle, noted where the pheromone was just updated.

The loop knows nothing of it: an update that notes stands in the place of one that does not, and is compiled into a
loop of its own.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import level
from acoexp.colony.state import Kernel


class Reel(NamedTuple):
    """The ways of all ants of all cycles, one after another.

    Attributes:
        moves: uint8[room], the directions taken.
        ends: int64[cycles, ants], where in ``moves`` an ant's way ends; it begins where the one before ends.
        length: float64[cycles, ants], in cells; inf for a lost ant.
    """

    moves: NDArray[np.uint8]
    ends: NDArray[np.int64]
    length: NDArray[np.float64]


class Tape(NamedTuple):
    """What is noted.

    Attributes:
        walked: The ways as walked, those of lost ants too.
        polished: The ways as optimised, nothing for a lost ant; without cycles if there is no post-optimiser.
        levels: float32[cycles + 1, cells], after each cycle the highest level of pheromone on an edge into a
            cell, of the two colonies' where ants set out from both ends; the first row is not noted.
        noted: int64[1], the cycle that is noted.
        full: uint8[1], not 0 once there was no room for a way; the trial is stopped then.
    """

    walked: Reel
    polished: Reel
    levels: NDArray[np.float32]
    noted: NDArray[np.int64]
    full: NDArray[np.uint8]


class Noted(NamedTuple):
    """The state of an update that notes: the part's own, and the tape."""

    own: Any
    tape: Tape


def noting(update: Kernel) -> Kernel:
    """Return a kernel that updates, then notes what the cycle was; its own state is a :class:`Noted`."""

    @compiled
    def update_and_note(colony: Any, noted: Any, raw: Any, final: Any, best: Any) -> None:
        tape, cycle = noted.tape, colony.cycle[0]
        update(colony, noted.own, raw, final, best)
        if tape.noted[0] != cycle:
            tape.noted[0] = cycle
            tape.levels[cycle] = 0.0
            walked, polished = tape.walked, tape.polished
            if not (note_ways(raw, walked, cycle - 1, True) and note_ways(final, polished, cycle - 1, False)):
                tape.full[0] = colony.stop[0] = 1
        note_levels(colony, tape.levels[cycle])  # of the colony at the goal, too, whose turn comes after

    return update_and_note


@compiled
def note_ways(trails: Any, reel: Any, cycle: Any, of_lost: Any) -> Any:
    """Note the ways of a cycle's ants, the first being 0; return False if there is no room for them."""
    cycles, ants = reel.ends.shape
    if cycles == 0:
        return True
    end = reel.ends[cycle - 1, ants - 1] if cycle > 0 else 0
    for ant in range(ants):
        steps = trails.steps[ant] if of_lost or trails.length[ant] < np.inf else 0
        if end + steps > reel.moves.size:
            return False
        for step in range(steps):
            reel.moves[end + step] = trails.moves[ant, step]
        end += steps
        reel.ends[cycle, ant] = end
        reel.length[cycle, ant] = trails.length[ant]
    return True


@compiled
def note_levels(colony: Any, levels: Any) -> None:
    """Raise what is noted of each cell to the highest level on an edge into it."""
    for cell in range(levels.size):
        for back in range(8):
            if colony.allowed[cell] >> back & 1:  # a way that can be gone can be come
                edge = (cell + colony.offsets[back]) * 8 + (back ^ 4)
                levels[cell] = max(levels[cell], np.float32(level(colony, edge)))
