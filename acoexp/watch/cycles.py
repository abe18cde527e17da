"""Cycles: all that happened in a trial, one after another, for programs and for the page."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.tape import Reel, Tape
from acoexp.errors import SettingsError, shown
from acoexp.grid.grid import Grid
from acoexp.trial.result import Result
from acoexp.trial.settings import Settings

Moves = NDArray[np.uint8]
"""A way as directions 0..7 from the start, see :data:`acoexp.grid.moves.DIRECTIONS`."""


class Way(NamedTuple):
    """What one ant did in a cycle.

    Attributes:
        moves: As it walked, without the moves that it gave back; of a lost ant as far as it came. Where ants set
            out from both ends, the path that two made together, or the way of the one from the start.
        polished: As the post-optimiser left it; None if there is none, or the ant was lost.
        length: In cells, of the shorter of both; inf for a lost ant.
    """

    moves: Moves
    polished: Moves | None
    length: float

    @property
    def lost(self) -> bool:
        """Whether the ant did not arrive."""
        return self.length == np.inf


class Best(NamedTuple):
    """A path that was the best so far, from the cycle (1, 2 ...) that found it on."""

    cycle: int
    moves: Moves
    length: float


@dataclass(frozen=True, eq=False, repr=False)
class Cycles:
    """One trial, cycle by cycle; they are counted from 1.

    Attributes:
        result: What the trial found, bit for bit what :func:`acoexp.solve` returns.
        settings: What it was run with.
        desirability: eta^beta of each move from each cell, float64[rows, cols, 8]; 0 where it is not allowed.
        tape: What was noted.
    """

    result: Result
    settings: Settings
    desirability: NDArray[np.float64]
    tape: Tape

    @property
    def grid(self) -> Grid:
        """The map."""
        return self.result.grid

    @property
    def cycles(self) -> int:
        """How many cycles there are."""
        return len(self.tape.walked.ends)

    @property
    def pheromone(self) -> NDArray[np.float32]:
        """Pheromone on each cell, float32[cycles + 1, rows, cols]: before the first cycle, and after each.

        It is the highest level on an edge into the cell, of both colonies where ants set out from both ends; 0
        where no move leads. Only levels relative to each other count.
        """
        rows, cols = self.grid.shape
        return self.tape.levels.reshape(-1, rows + 2, cols + 2)[:, 1:-1, 1:-1]

    def ways(self, cycle: int) -> list[Way]:
        """Return what each ant of a cycle did, in their order.

        Raises:
            SettingsError: if the cycle is not a whole number from 1 to the number of cycles.
        """
        row = self.checked(cycle) - 1
        walked, polished = _cut(self.tape.walked, row), _cut(self.tape.polished, row)
        return [
            Way(moves, polished[ant] if polished and length < np.inf else None, length)
            for ant, (moves, length) in enumerate(zip(walked, self.lengths[row].tolist(), strict=True))
        ]

    @cached_property
    def lengths(self) -> NDArray[np.float64]:
        """Length of each ant's path, float64[cycles, ants], of the shorter as walked and polished; inf if lost."""
        walked, polished = self.tape.walked.length, self.tape.polished.length
        return np.minimum(walked, polished) if polished.size else walked

    @property
    def winners(self) -> NDArray[np.int64]:
        """The ant, 0-based, whose path was each cycle's best, int64[cycles]; -1 where all were lost."""
        first = self.lengths.argmin(axis=1)
        return np.where(np.isinf(self.lengths.min(axis=1)), -1, first)

    @cached_property
    def bests(self) -> list[Best]:
        """Each path that was the best so far, in the order in which they were found."""
        found: list[Best] = []
        for row, ant in enumerate(self.winners.tolist()):
            if ant >= 0 and (not found or self.lengths[row, ant] < found[-1].length):
                found.append(Best(row + 1, self._path(row, ant), float(self.lengths[row, ant])))
        return found

    def _path(self, row: int, ant: int) -> Moves:
        walked, polished = self.tape.walked, self.tape.polished
        optimised = polished.length.size and polished.length[row, ant] <= walked.length[row, ant]
        return _cut(polished if optimised else walked, row)[ant]

    def checked(self, cycle: int) -> int:
        """Return a cycle's number.

        Raises:
            SettingsError: if it is not a whole number from 1 to the number of cycles.
        """
        if isinstance(cycle, bool) or not isinstance(cycle, int | np.integer) or not 1 <= cycle <= self.cycles:
            raise SettingsError(f"cycle: expected a whole number from 1 to {self.cycles}; got {shown(cycle)}")
        return int(cycle)

    def __repr__(self) -> str:
        return f"<recording of {self.cycles} cycles of {self.result!r}>"


def _cut(reel: Reel, row: int) -> list[Moves]:
    """Return the ways of a cycle's ants; none if the reel has no cycles."""
    if not reel.ends.size:
        return []
    begin = int(reel.ends[row - 1, -1]) if row > 0 else 0
    return np.split(reel.moves[begin : reel.ends[row, -1]], reel.ends[row, :-1] - begin)
