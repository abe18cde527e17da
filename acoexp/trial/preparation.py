"""Preparation: what a colony's parts are asked for before the first cycle, each answer checked."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.colony import diagnosis
from acoexp.colony.problem import Problem
from acoexp.colony.state import Own, Prepared
from acoexp.errors import StrategyError
from acoexp.trial.settings import Settings

DESIRABILITY_LIMIT = 1e200
"""eta^beta is cut off here: with pheromone's own bound, no sum of weights overflows."""

_STRIP = 2**12
"""Cells of which all moves are looked at at a time: as many as the processor keeps at hand."""


def prepare(problem: Problem, settings: Settings) -> Prepared:
    """Ask the parts for what they prepare.

    Raises:
        StrategyError: if a part fails, or answers with what is not asked for.
    """
    asked = _Asked(problem, settings)
    own = Own(*(asked.for_state(group) for group in Own._fields))
    return Prepared(asked.for_desirability(), asked.for_initial_pheromone(), own)


@dataclass(frozen=True)
class _Asked:
    problem: Problem
    settings: Settings

    def for_state(self, group: str) -> Any:
        state = self._answer(group, "prepare")
        _check_state(state, self.settings.describe(group))
        return state

    def for_desirability(self) -> NDArray[np.float64]:
        eta = self._per_move("heuristic", "eta")
        rows, cols = self.problem.grid.shape
        desirability = np.zeros((rows + 2, cols + 2, 8))
        for strip, allowed in self._strips():
            power = desirability[1:-1, 1:-1][strip]
            with np.errstate(over="ignore"):
                np.power(eta[strip], self.settings.scalars.beta, where=allowed, out=power)
            np.minimum(power, DESIRABILITY_LIMIT, out=power)
        desirability.flags.writeable = False
        return desirability.ravel()

    def for_initial_pheromone(self) -> NDArray[np.float64]:
        initial = self._per_move("update", "initial")
        if initial.strides == (0, 0, 0):  # one level, broadcast
            return initial[0, 0, :1].copy()
        if self.settings.scalars.pheromone == "cells":
            initial = self.problem.shared_by_target(initial)
        return self.problem.per_edge(initial, border=0.0)

    def _per_move(self, group: str, method: str) -> NDArray[np.float64]:
        """Ask a part for a number per move, float64[rows, cols, 8], and check it."""
        given, shape = self._answer(group, method), (*self.problem.grid.shape, 8)
        problem = f"{self.settings.describe(group)}: expected {method} to return numbers"
        if given is None:  # which NumPy would take for nan
            raise StrategyError(f"{problem}; got None, which is what a function without a return gives")
        try:
            array = np.asarray(given)
            values = np.broadcast_to(array.astype(np.float64, casting="same_kind", copy=False), shape)
        except KeyboardInterrupt:
            raise
        except BaseException as reason:  # a ragged list, or an object with ideas of its own
            came = (
                f"{given.dtype} of shape {given.shape}" if isinstance(given, np.ndarray) else type(given).__name__
            )
            raise StrategyError(f"{problem} of a shape that broadcasts to {shape}; got {came}") from reason
        if any(values.strides):
            sound = all(_sound(values[strip])[allowed].all() for strip, allowed in self._strips())
        else:  # one number for all
            sound = bool(_sound(values[0, 0, 0]))
        if not sound:
            raise StrategyError(f"{problem} that are finite, and at least 0, on every move; got others")
        return values

    def _strips(self) -> Iterator[tuple[slice, NDArray[np.bool_]]]:
        """Yield the map's rows, some at a time, with what moves they allow: no large array is made on the way."""
        rows, cols = self.problem.grid.shape
        height = max(1, _STRIP // cols)
        for top in range(0, rows, height):
            strip = slice(top, top + height)
            yield strip, self.problem.allowed_edges(strip)

    def _answer(self, group: str, method: str) -> Any:
        """Call a part's method with the problem."""
        part = self.settings.parts[group]
        with diagnosis.faults_of(part, self.settings.describe(group), method):
            return getattr(part, method)(self.problem)


def _sound(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell which numbers are finite, and at least 0."""
    return (values >= 0.0) & (values < np.inf)


def _check_state(state: Any, described: str) -> None:
    """Refuse what no kernel can take as a part's own state: anything but a tuple of numbers and arrays."""
    expected = f"{described}: expected prepare to return a tuple of numbers and arrays"
    if not isinstance(state, tuple):
        raise StrategyError(f"{expected}; got {type(state).__name__}")
    for place, value in enumerate(state):
        number = isinstance(value, np.number | np.bool_ | int | float | complex)
        array = isinstance(value, np.ndarray) and value.dtype.kind in "biufc"
        if not (number or array):
            raise StrategyError(f"{expected}; got {type(value).__name__} at place {place}")
