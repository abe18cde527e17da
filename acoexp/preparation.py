"""Preparation: what a colony's parts are asked for before the first cycle, each answer checked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp import blame
from acoexp.colony.loop import Own
from acoexp.colony.problem import Problem
from acoexp.errors import AcoexpError, StrategyError
from acoexp.settings import Settings

DESIRABILITY_LIMIT = 1e200
"""eta^beta is cut off here: with pheromone's own bound, no sum of weights overflows."""


class Prepared(NamedTuple):
    """What the parts have prepared for all trials.

    Attributes:
        desirability: eta^beta, float64[edges], 0 where a move is not allowed.
        initial: The initial pheromone, float64[1] or float64[edges].
        own: The parts' own states.
    """

    desirability: NDArray[np.float64]
    initial: NDArray[np.float64]
    own: Own


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
        blame.check_state(self.settings, group, state)
        return state

    def for_desirability(self) -> NDArray[np.float64]:
        allowed = self.problem.allowed_edges()
        eta = self._per_move("heuristic", "eta", allowed)
        with np.errstate(over="ignore"):
            power = np.power(eta, self.settings.scalars.beta, where=allowed, out=np.zeros(eta.shape))
        return self.problem.per_edge(np.minimum(power, DESIRABILITY_LIMIT), border=0.0)

    def for_initial_pheromone(self) -> NDArray[np.float64]:
        initial = self._per_move("update", "initial", self.problem.allowed_edges())
        if initial.strides == (0, 0, 0):  # one level, broadcast
            return initial[0, 0, :1].copy()
        if self.settings.scalars.pheromone == "cells":
            initial = self.problem.shared_by_target(initial)
        return self.problem.per_edge(initial, border=0.0)

    def _per_move(self, group: str, method: str, allowed: NDArray[np.bool_]) -> NDArray[np.float64]:
        """Ask a part for a number per move, float64[rows, cols, 8], and check it."""
        given = self._answer(group, method)
        problem = f"{blame.told(self.settings, group)}: expected {method} to return numbers"
        try:
            values = np.broadcast_to(np.asarray(given, dtype=np.float64), allowed.shape)
        except (TypeError, ValueError) as reason:
            came = f"{type(given).__name__} of shape {np.shape(given)}"
            raise StrategyError(f"{problem} of a shape that broadcasts to {allowed.shape}; got {came}") from reason
        if not (np.isfinite(values[allowed]).all() and (values[allowed] >= 0.0).all()):
            raise StrategyError(f"{problem} that are finite, and at least 0, on every move; got others")
        return values

    def _answer(self, group: str, method: str) -> Any:
        """Call a part's method with the problem; what goes wrong there is told with the part's name."""
        try:
            return getattr(self.settings.parts[group], method)(self.problem)
        except AcoexpError:
            raise
        except Exception as problem:
            raise blame.failed(self.settings, group, method, problem) from problem
