"""The result of a trial: the path, checked move by move, and everything that is measured on its way."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoexp.grid.grid import Grid
from acoexp.grid.moves import follow
from acoexp.trial.features import Features, curve_of, features_of, without_nan, x2_last
from acoexp.trial.quality import UNDEFINED, Quality, in_metres, quality_of

Pair = tuple[int, int]
"""A length as (straight, diagonal) moves, exact."""


def why_lost(after: float, optimum: float) -> str:
    """Say in some words why no ant arrived.

    Args:
        after: Moves after which they were lost, on average.
        optimum: Length of the shortest way.
    """
    return f"they were lost after {after:.0f} moves on average, and the goal is {optimum:.0f} cells away"


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """What one trial found.

    Attributes:
        algo: Label of the algorithm, ``custom`` if its parts are not a preset's.
        seed: The trial's seed.
        grid: The map.
        moves: uint8[n], the directions of the run's best path; None when no ant ever arrived.
        raw_moves: Those of that path as the ant walked it, where a post-optimiser worked; else None.
        curve_pairs: int[cycles, 2], (straight, diagonal) moves of the best path found in each cycle; -1 where
            all ants were lost. There are as many cycles as ``iterations``, or fewer where ``patience`` ended it.
        lost_ants: int[cycles], ants lost in each cycle.
        cycle_steps: int64[cycles], moves made by all ants together in each cycle.
    """

    algo: str
    seed: int
    grid: Grid
    moves: NDArray[np.uint8] | None
    raw_moves: NDArray[np.uint8] | None
    curve_pairs: NDArray[np.int32]
    lost_ants: NDArray[np.int32]
    cycle_steps: NDArray[np.int64]

    @property
    def ant_steps(self) -> int:
        """Moves made by all ants together."""
        return int(self.cycle_steps.sum())

    @cached_property
    def path(self) -> NDArray[np.int64] | None:
        """The run's best path as cells (row, column), int[n, 2]; None when no ant ever arrived."""
        return None if self.moves is None else follow(self.grid.start, self.moves)

    @cached_property
    def raw_path(self) -> NDArray[np.int64] | None:
        """That path as the ant walked it, where a post-optimiser worked; else None."""
        return None if self.raw_moves is None else follow(self.grid.start, self.raw_moves)

    @cached_property
    def curve(self) -> NDArray[np.float64]:
        """Best length found in each cycle, float[cycles]; nan where all ants were lost."""
        return curve_of(self.curve_pairs)

    @cached_property
    def features(self) -> Features:
        """The features of the curve."""
        return features_of(self.curve)

    @cached_property
    def quality(self) -> Quality:
        """How good ``path`` is to drive."""
        if self.moves is None or self.path is None:
            return UNDEFINED
        clearance = self.grid.clearance[tuple(self.path.T)]
        return quality_of(self.moves, clearance, self.grid.any_angle_optimum)

    @property
    def cycles(self) -> int:
        """Cycles that were run."""
        return len(self.curve_pairs)

    @property
    def x1(self) -> int:
        """First cycle that found the run's best length; 0 if there is none."""
        return self.features.x1

    @property
    def x2(self) -> int:
        """First cycle that found it twice in a row, or else the last that found it; 0 if there is none."""
        return self.features.x2

    @property
    def x2_last(self) -> int:
        """``x2`` in its other reading: the last cycle that found the best length, where ``l2`` differs from it."""
        return x2_last(self.curve)

    @property
    def x3(self) -> int:
        """First cycle from which on the curve stays at ``l2``; 0 if there is none."""
        return self.features.x3

    @property
    def l1(self) -> float:
        """Best length of the run, in cells; nan if no ant ever arrived."""
        return self.features.l1

    @property
    def l2(self) -> float:
        """Length of convergence, the last cycle's best; nan if all its ants were lost."""
        return self.features.l2

    @property
    def length(self) -> float:
        """Length of ``path``, the same as ``l1``."""
        return self.features.l1

    @property
    def optimum(self) -> float:
        """Exact length of a shortest path on the map."""
        return self.grid.optimum

    @property
    def optimum_pair(self) -> Pair:
        """The exact optimum as (straight, diagonal) moves."""
        return self.grid.optimum_pair

    @property
    def l1_pair(self) -> Pair | None:
        """``l1`` as (straight, diagonal) moves."""
        return self._pair(self.x1)

    @property
    def l2_pair(self) -> Pair | None:
        """``l2`` as (straight, diagonal) moves."""
        return self._pair(self.x3)

    @property
    def found_optimum(self) -> bool:
        """Whether the run's best path is a shortest one."""
        return self.l1_pair == self.optimum_pair

    @property
    def lost_after(self) -> float:
        """Moves after which an ant was lost, on average, where none ever arrived; nan where one did."""
        return self.ant_steps / int(self.lost_ants.sum()) if self.moves is None else math.nan

    def as_dict(self) -> dict[str, Any]:
        """Return everything as plain values for JSON; None where there is no value."""
        quality = self.quality._asdict()
        plain = {
            "algo": self.algo,
            "map": self.grid.name,
            "map_digest": self.grid.digest,
            "seed": self.seed,
            **self.features._asdict(),
            **quality,
            **in_metres(quality, self.grid.frame),
            "optimum": self.optimum,
            "any_angle_optimum": self.grid.any_angle_optimum,
            "l1_pair": self.l1_pair,
            "l2_pair": self.l2_pair,
            "optimum_pair": self.optimum_pair,
            "cycles": self.cycles,
            "lost_ants": self.lost_ants.tolist(),
            "ant_steps": self.ant_steps,
            "curve": self.curve.tolist(),
            "path": None if self.path is None else self.path.tolist(),
            "raw_path": None if self.raw_path is None else self.raw_path.tolist(),
        }
        found: dict[str, Any] = without_nan(plain)
        return found

    def _pair(self, cycle: int) -> Pair | None:
        if cycle == 0:
            return None
        straight, diagonal = self.curve_pairs[cycle - 1].tolist()
        return straight, diagonal

    def __repr__(self) -> str:
        found = f"l1={self.l1:.4f} l2={self.l2:.4f} x1={self.x1} x2={self.x2} x3={self.x3}"
        if self.moves is None:
            found = f"no ant arrived: {why_lost(self.lost_after, self.optimum)}"
        return (
            f"<{self.algo} on {self.grid.name}, seed {self.seed}: {found}, optimum {self.optimum:.4f}, "
            f"{int(self.lost_ants.sum())} ants lost>"
        )
