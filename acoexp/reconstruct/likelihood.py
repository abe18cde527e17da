"""The fit: the likelihood of the ten published trials under a map's simulated ones.

A published trial is four numbers (l1, l2, x1, x3). Its density is estimated from simulated trials by a product
kernel for mixed data (Li and Racine 2003): for the lengths, which are categories, Aitchison and Aitken's kernel
(1976); for the cycles, a discrete normal kernel on their logarithms. The published x2 is left out: its
definition is doubtful.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.moves import path_length
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import CYCLES, Environment

_BANDWIDTH = 0.2
"""Of log cycles: a published x1 of 10 is met by 8 and 12 almost as well."""

_EVENLY = 0.05
"""Weight of an even distribution over all cycles."""

_MISMATCH = 0.05
"""Weight that a length of another category has, so that a poor map can be told from a worse one."""

_CATEGORIES = 6
"""Among how many categories a mismatch is spread."""

_PRECISION = 6e-5
"""Printed lengths have four decimals."""


def score(environment: Environment, simulated: Outcomes) -> float:
    """Return how well simulated trials fit: the log-likelihood of the published ones.

    Where none are published (env1), that of ten trials which find the optimum.
    """
    if environment.has_trials:
        return log_likelihood(environment.trials, simulated)
    found = int((simulated.l1 == path_length(*environment.optimum)).sum())
    return 10.0 * float(np.log((found + 0.5) / (simulated.size + 1.0)))


def log_likelihood(published: Outcomes, simulated: Outcomes) -> float:
    """Return the log-likelihood of published trials under the distribution that simulated ones are drawn from.

    Args:
        published: n trials.
        simulated: m trials, at least one.

    Returns:
        The sum over the published trials, at most 0.
    """
    kernel = (
        _same(published.l1, simulated.l1)
        * _same(published.l2, simulated.l2)
        * _near(published.x1, simulated.x1)
        * _near(published.x3, simulated.x3)
    )
    return float(np.log(kernel.mean(axis=1)).sum())


def matches(published: NDArray[np.float64], simulated: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return bool[n, m]: which simulated lengths are which published ones."""
    return np.abs(published[:, None] - simulated) < _PRECISION


def _same(published: NDArray[np.float64], simulated: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.where(matches(published, simulated), 1.0 - _MISMATCH, _MISMATCH / (_CATEGORIES - 1))


def _near(published: NDArray[np.int64], simulated: NDArray[np.int64]) -> NDArray[np.float64]:
    return _CYCLE_KERNEL[simulated[None, :], published[:, None]]


def _cycle_kernel() -> NDArray[np.float64]:
    """Return float64[201, 201], by simulated and published cycle; a trial in which no ant arrived has cycle 0."""
    logs = np.log(np.maximum(np.arange(CYCLES + 1), 0.5))
    kernel = np.exp(-0.5 * ((logs[:, None] - logs) / _BANDWIDTH) ** 2)
    kernel[:, 0] = 0.0
    kernel /= kernel.sum(axis=1, keepdims=True)
    return (1.0 - _EVENLY) * kernel + _EVENLY / CYCLES


_CYCLE_KERNEL = _cycle_kernel()
