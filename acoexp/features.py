"""The features x1, x2, x3, l1, l2 of a convergence curve (Liu et al. 2017, Fig. 15 and Tables 1, 2).

c(t), t = 1..K, is the length of the best path found *in* cycle t, nan where all ants were lost. Lengths come
from :func:`acoexp.grid.path_length`, so equal pairs of moves are equal floats and may be compared.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


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
