"""The global update of ACS, by hand on a map of 3 x 3 cells: the best path's edges change, and no others."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from acoexp.strategies.update.global_best import GlobalBest

E, NE, N, NW, W, SW, S, SE = range(8)

LONG, SHORT, BENT = [E, E, S, S], [SE, SE], [E, SE, S]
Q, TAU0 = 6.0, 2.0


def test_only_the_best_paths_edges_change(updated: Callable[..., Any]) -> None:
    levels = updated(GlobalBest(), LONG, BENT, best=SHORT)
    assert math.isclose(levels[0, 0, SE], 0.75 * TAU0 + 0.25 * Q / math.sqrt(8.0))
    assert levels[0, 0, E] == TAU0


def test_as_long_as_no_ant_has_arrived_nothing_is_laid(updated: Callable[..., Any]) -> None:
    assert np.unique(updated(GlobalBest(), None, None, best=None)).size == 1


def test_its_preset_learns(learns: Callable[[str], bool]) -> None:
    assert learns("acs")
