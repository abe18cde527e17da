"""The recorder: a solver whose loop notes every cycle on a tape; what it finds is bit for bit what others find."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.state import Kernel, Own
from acoexp.colony.tape import Noted, Reel, Tape, noting
from acoexp.errors import SettingsError
from acoexp.grid.grid import Grid
from acoexp.trial.result import Result
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver, loop_of
from acoexp.trial.workspace import End, Workspace, direction_offsets

LARGEST = 2**29
"""Bytes that pheromone may take on a tape, and each kind of ways."""

_noting = lru_cache(maxsize=None)(noting)


class Recorder(Solver):
    """Records trials of one configuration on one map."""

    def record(self, seed: int) -> tuple[Result, Tape]:
        """Run one trial and return what it found, as :func:`solve` would, and the tape of its cycles.

        Raises:
            SettingsError: if the seed is not a whole number from 0 to 2^64 - 1, or there is more to record than
                ``LARGEST`` bytes of pheromone, or of ways.
            StrategyError: if a part broke its contract.
        """
        result, tape = self.solve(seed), self._tape
        walked, polished = _wound(tape.walked, result.cycles), _wound(tape.polished, result.cycles)
        return result, tape._replace(walked=walked, polished=polished, levels=tape.levels[: result.cycles + 1])

    @property
    def desirability(self) -> NDArray[np.float64]:
        """What the heuristic makes of each move, eta^beta, float64[rows, cols, 8]; 0 if not allowed."""
        (problem, prepared), *_ = self._ends
        return prepared.desirability.reshape(-1, problem.width, 8)[1:-1, 1:-1]

    def _make_loop(self) -> tuple[Kernel, tuple[object, ...]]:
        kernels, (_, made_of) = self._kernels, super()._make_loop()
        recorded = kernels._replace(update=_noting(kernels.update))
        return loop_of(*self._walks, recorded), ("recorded", *made_of)

    def _new_workspace(self, stop: NDArray[np.uint8] | None = None) -> Workspace:
        workspace = super()._new_workspace(stop)
        self._tape, room = self._new_tape(), workspace.room
        facing = room.facing
        if facing is not None:
            facing = facing._replace(own=_with(facing.own, self._tape))
        return workspace._replace(room=room._replace(own=_with(room.own, self._tape), facing=facing))

    def _new_tape(self) -> Tape:
        check_size(self.grid, self.settings)
        cycles, ants = self.settings.scalars.iterations, self.settings.scalars.ants
        bordered = self._ends[0].prepared.desirability.size // 8
        levels = np.empty((cycles + 1, bordered), dtype=np.float32)
        levels[0] = np.max([_into_cells(end) for end in self._ends], axis=0)
        has_post = self._kernels.post is not None
        return Tape(
            walked=_new_reel(cycles, ants, bordered),
            polished=_new_reel(cycles if has_post else 0, ants, bordered),
            levels=levels,
            noted=np.zeros(1, dtype=np.int64),
            full=np.zeros(1, dtype=np.uint8),
        )

    def _check(self, verdict: int, seed: int) -> None:
        if self._tape.full[0]:
            scalars = self.settings.scalars
            raise SettingsError(
                f"ants: expected fewer, or fewer iterations, for a recording, whose ways may have {LARGEST} moves "
                f"in all; got {scalars.ants} ants in {scalars.iterations} cycles"
            )
        super()._check(verdict, seed)


def check_size(grid: Grid, settings: Settings) -> None:
    """Refuse what there is too much of to be recorded.

    Raises:
        SettingsError: if pheromone, or what is noted of each ant, would take more than ``LARGEST`` bytes.
    """
    cells, cycles, ants = grid.obstacles.size, settings.scalars.iterations, settings.scalars.ants
    bordered = cells + 2 * sum(grid.shape) + 4
    most = min(LARGEST // (4 * bordered) - 1, LARGEST // (16 * ants))
    if cycles > most:
        raise SettingsError(
            f"iterations: expected at most {most} to record {ants} ants on {cells} cells; got {cycles}"
        )


def _with(own: Own, tape: Tape) -> Own:
    """Return the parts' own states, that of the update with a tape."""
    return own._replace(update=Noted(own.update, tape))


def _new_reel(cycles: int, ants: int, cells: int) -> Reel:
    """Return room for ways; the system gives memory only for what is written."""
    return Reel(
        moves=np.empty(min(cycles * ants * cells, LARGEST), dtype=np.uint8),
        ends=np.empty((cycles, ants), dtype=np.int64),
        length=np.empty((cycles, ants)),
    )


def _wound(reel: Reel, cycles: int) -> Reel:
    """Return a reel without the room that was not used in so many cycles."""
    ends = reel.ends[:cycles]
    return Reel(reel.moves[: ends[-1, -1] if ends.size else 0].copy(), ends, reel.length[:cycles])


def _into_cells(end: End) -> NDArray[np.float64]:
    """Return the highest initial level of pheromone on an edge into each cell, float64[cells]."""
    problem, initial = end.problem, end.prepared.initial
    allowed = problem.per_cell(problem.grid.allowed, border=0)
    levels = np.zeros(allowed.size)
    for direction, offset in enumerate(direction_offsets(problem.width)):
        level = initial[0] if initial.size == 1 else initial[direction::8]
        leaving = np.where(allowed >> direction & 1, level, 0.0)
        np.maximum(levels, np.roll(leaving, offset), out=levels)
    return levels
