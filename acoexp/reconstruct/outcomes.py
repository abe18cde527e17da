"""Outcomes: what trials came to, as far as the paper prints it of its own."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.trial.features import curve_of, features_of


class Outcomes(NamedTuple):
    """What trials came to, one entry per trial: int64 cycles and float64 lengths, as in ``Features``."""

    x1: NDArray[np.int64]
    x3: NDArray[np.int64]
    l1: NDArray[np.float64]
    l2: NDArray[np.float64]

    @classmethod
    def of(cls, curve_pairs: Iterable[NDArray[Any]]) -> Outcomes:
        """Return what one or more trials came to.

        Args:
            curve_pairs: Of each trial int[K, 2], as in :class:`~acoexp.trial.result.Result`; all K alike.
        """
        features = [features_of(curve) for curve in curve_of(np.array(list(curve_pairs)))]
        cycles = np.array([(f.x1, f.x3) for f in features], dtype=np.int64)
        lengths = np.array([(f.l1, f.l2) for f in features], dtype=np.float64)
        return cls(*cycles.T, *lengths.T)

    @property
    def size(self) -> int:
        """Number of trials."""
        return self.x1.size

    def joined(self, other: Outcomes) -> Outcomes:
        """Return the trials of both."""
        return Outcomes(*(np.concatenate(pair) for pair in zip(self, other, strict=True)))
