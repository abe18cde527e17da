"""The features x1, x2, x3, l1, l2 of a convergence curve (Liu et al. 2017, Fig. 15 and Tables 1, 2).

c(t), t = 1..K, is the length of the best path found *in* cycle t, nan where all ants were lost. Lengths come
from :func:`acoexp.grid.path_length`, so equal pairs of moves are equal floats and may be compared.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.moves import path_length


class Features(NamedTuple):
    """Cycles are 1-based; 0 stands for "there is none", as nan does for lengths.

    Attributes:
        x1: First cycle that found the run's best length.
        x2: First cycle that found it and whose successor did too, or else the last that found it.
        x3: First cycle from which on the curve stays at ``l2``.
        l1: Best length of the run.
        l2: Length of convergence: the last cycle's best.
    """

    x1: int
    x2: int
    x3: int
    l1: float
    l2: float


NAMES = (
    *Features._fields,
    *("turns", "turning", "clearance_mean", "clearance_least", "detour"),
    *("cycles", "lost_ants", "ant_steps"),
)
"""What is measured of a trial, as its record, its row of a table and its MLflow metrics call it."""

CYCLES = ("x1", "x2", "x3")
"""Those that are cycles: 0 where undefined. The others are numbers: nan where undefined."""


def curve_of(pairs: NDArray[Any]) -> NDArray[np.float64]:
    """Return the lengths of (straight, diagonal) moves, int[..., 2] -> float[...]; nan for (-1, -1), no path."""
    straight, diagonal = np.moveaxis(pairs.astype(np.float64), -1, 0)
    return np.where(straight < 0, np.nan, path_length(straight, diagonal))


def prolonged(pairs: NDArray[Any], cycles: int) -> NDArray[Any]:
    """Return the moves of each cycle, int[..., K, 2], as of a trial of so many cycles that stays as in its last.

    All features stay what they are, so trials that ended sooner than others may stand beside them.
    """
    more = cycles - pairs.shape[-2]
    return np.pad(pairs, [*[(0, 0)] * (pairs.ndim - 2), (0, more), (0, 0)], mode="edge")


def best_so_far(curve: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the best length up to each cycle, float[..., K], of curves, float[..., K]; nan before the first."""
    return np.fmin.accumulate(curve, axis=-1)


def defined(name: str, values: NDArray[Any]) -> NDArray[np.float64]:
    """Return a feature's values, one for each trial, as float[n] with nan where it is undefined."""
    numbers = values.astype(np.float64)
    return np.where(numbers == 0.0, np.nan, numbers) if name in CYCLES else numbers


def without_nan(value: Any) -> Any:
    """Return nested plain values as JSON has them: None where a number is not one."""
    if isinstance(value, dict):
        return {key: without_nan(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [without_nan(inner) for inner in value]
    return None if isinstance(value, float) and math.isnan(value) else value


def x2_last(curve: NDArray[np.float64]) -> int:
    """Return x2 of a curve, float[K], in its other reading: the last cycle that found the best length.

    The published x2 lie close to x3. Where the run converges to its best length, that would be the last cycle of
    all; there, it is x2 as :class:`Features` has it.
    """
    features = features_of(curve)
    if features.x1 == 0 or features.l1 == features.l2:
        return features.x2
    return int(np.flatnonzero(curve == features.l1)[-1]) + 1


def features_of(curve: NDArray[np.float64]) -> Features:
    """Return the features of a curve, float[K]."""
    if np.isnan(curve).all():
        return Features(0, 0, 0, np.nan, np.nan)
    l1 = float(np.nanmin(curve))
    at_best = curve == l1
    in_a_row = np.flatnonzero(at_best[:-1] & at_best[1:])
    found = np.flatnonzero(at_best)
    x2 = in_a_row[0] if in_a_row.size else found[-1]
    l2 = float(curve[-1])
    elsewhere = np.flatnonzero(curve != l2)
    x3 = (int(elsewhere[-1]) + 2 if elsewhere.size else 1) if not np.isnan(l2) else 0
    return Features(int(found[0]) + 1, int(x2) + 1, x3, l1, l2)
