"""Trials of standard ACO on one map after the other: the compiled loop of ``algo=aco``, the map exchanged.

A :class:`~acoexp.solver.Solver` is made for one map and takes a few milliseconds to be; a search cannot wait
for that. The arrays through which the loop sees a map are all that differs between two maps of one shape.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.colony.cache import compile_once
from acoexp.colony.loop import Own, Record, make_loop
from acoexp.colony.problem import Problem
from acoexp.colony.state import new_colony, new_trails
from acoexp.colony.walk import ORDERS
from acoexp.features import Features, features_of
from acoexp.grid import Grid, allowed_moves, path_length
from acoexp.reconstruct.screen import SIZE
from acoexp.settings import resolve


class Outcomes(NamedTuple):
    """What trials came to, one entry per trial: int64 cycles and float64 lengths, as in :class:`Features`."""

    x1: NDArray[np.int64]
    x3: NDArray[np.int64]
    l1: NDArray[np.float64]
    l2: NDArray[np.float64]

    @property
    def size(self) -> int:
        """Number of trials."""
        return self.x1.size

    def joined(self, other: Outcomes) -> Outcomes:
        """Return the trials of both."""
        return Outcomes(*(np.concatenate(pair) for pair in zip(self, other, strict=True)))


class Colonies:
    """Standard ACO with the paper's settings on one 20 x 20 map after the other; for one thread."""

    def __init__(self, moves: str, cycles: int) -> None:
        settings = resolve("aco", {"iterations": cycles})
        self._moves = moves
        self._problem = problem = Problem(
            Grid(np.zeros((SIZE, SIZE)), moves="free"), settings.scalars, settings.field
        )
        eta = settings.parts["heuristic"].eta(problem)
        allowed = problem.allowed_edges()
        self._unhindered = problem.per_edge(np.where(allowed, eta, 0.0) ** settings.scalars.beta, border=0.0)
        self._allowed, self._desirability = np.zeros(self._unhindered.size // 8, np.uint8), self._unhindered.copy()
        seen = self._allowed.view(), self._desirability.view()
        for view in seen:
            view.flags.writeable = False  # what the loop was compiled for
        colony = new_colony(problem, seen[1], np.zeros(1, dtype=np.uint8))._replace(allowed=seen[0])
        cells = self._allowed.size
        raw = new_trails(settings.scalars.ants, cells)
        kernels = {group: settings.parts[group].kernel for group in Own._fields}
        own = Own(*(settings.parts[group].prepare(problem) for group in Own._fields))
        initial = np.array([settings.scalars.tau0])
        order = ORDERS[settings.scalars.order]
        self._arguments = colony, None, own, initial, raw, raw, new_trails(2, cells), np.empty(1, dtype=np.int32)
        self._iterations = settings.scalars.iterations
        self._loop = make_loop(order, *kernels.values())
        compile_once(self._loop, (order, *kernels.values()), (*self._arguments, self._new_record(), np.uint64(0)))

    def run(self, obstacles: NDArray[np.bool_], seeds: Iterable[int]) -> Outcomes:
        """Run one trial per seed on a map, bool[20, 20], and return what they came to.

        They are the trials of ``acoexp.solve_many(..., algo="aco")``, bit for bit.
        """
        self._allowed[:] = self._problem.per_cell(allowed_moves(obstacles, self._moves), border=0)
        bits = np.unpackbits(self._allowed[:, None], axis=1, bitorder="little").ravel()
        np.multiply(self._unhindered, bits, out=self._desirability)
        features = [self._trial(seed) for seed in seeds]
        cycles = np.array([(f.x1, f.x3) for f in features], dtype=np.int64).reshape(-1, 2)
        lengths = np.array([(f.l1, f.l2) for f in features], dtype=np.float64).reshape(-1, 2)
        return Outcomes(*cycles.T, *lengths.T)

    def _trial(self, seed: int) -> Features:
        record = self._new_record()
        with np.errstate(over="ignore"):  # without the JIT; uint64 wraps around on purpose
            self._loop(*self._arguments, record, np.uint64(seed))
        straight, diagonal = record.pairs.T.astype(np.float64)
        return features_of(np.where(straight < 0, np.nan, path_length(straight, diagonal)))

    def _new_record(self) -> Record:
        pairs, lost = np.empty((self._iterations, 2), dtype=np.int32), np.empty(self._iterations, dtype=np.int32)
        return Record(pairs, lost, np.zeros(1, dtype=np.int64))
