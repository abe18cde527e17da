"""How good a path is to drive: how much it turns, how near it comes to obstacles, how long it need have been."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.frame import Frame
from acoexp.grid.moves import path_length


class Quality(NamedTuple):
    """The quality of a path; each nan where it is undefined.

    Attributes:
        turns: Cells on which it changes its direction.
        turning: By how much it does so altogether, in radians.
        clearance_mean: Mean of :attr:`~acoexp.grid.grid.Grid.clearance` over its cells, in cells.
        clearance_least: The least of them.
        detour: Its length over :attr:`~acoexp.grid.grid.Grid.any_angle_optimum`.
    """

    turns: float
    turning: float
    clearance_mean: float
    clearance_least: float
    detour: float


UNDEFINED = Quality(*[math.nan] * len(Quality._fields))
"""The quality where there is no path."""


def quality_of(moves: NDArray[np.uint8], clearance: NDArray[np.float64], shortest: float) -> Quality:
    """Return the quality of a path.

    Args:
        moves: uint8[n], the directions 0..7 that it goes.
        clearance: float[n + 1], that of each of its cells.
        shortest: Length of the shortest way at any angles.
    """
    bends: NDArray[np.int64] = np.abs(np.diff(moves.astype(np.int64)))
    eighths = np.minimum(bends, 8 - bends)
    diagonal = int((moves % 2).sum())
    return Quality(
        turns=float(np.count_nonzero(eighths)),
        turning=float(eighths.sum()) * math.pi / 4,
        clearance_mean=float(clearance.mean()),
        clearance_least=float(clearance.min()),
        detour=path_length(moves.size - diagonal, diagonal) / shortest,
    )


def in_metres(values: Mapping[str, float], frame: Frame | None) -> dict[str, float]:
    """Return the clearances among some values in metres, by name and ``_m``; none of a map without a frame."""
    if frame is None:
        return {}
    names = ("clearance_mean", "clearance_least")
    return {f"{name}_m": frame.resolution * values[name] for name in names if name in values}
