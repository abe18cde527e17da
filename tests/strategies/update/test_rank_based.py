"""The rank-based ant system, by hand on a map of 3 x 3 cells: who is shorter lays more, and few lay at all."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from acoexp.errors import SettingsError
from acoexp.parameters import build
from acoexp.strategies.update.rank_based import RankBased

E, NE, N, NW, W, SW, S, SE = range(8)

LONG, SHORT, BENT = [E, E, S, S], [SE, SE], [E, SE, S]
Q = 6.0


def test_ants_lay_by_rank_and_the_best_path_gets_most(updated: Callable[..., Any]) -> None:
    levels = updated(RankBased(ranks=3), LONG, BENT, None, BENT, best=SHORT)
    assert math.isclose(levels[0, 0, E], 1.5 + (2 + 1) * Q / (2.0 + math.sqrt(2.0)))
    assert levels[0, 1, E] == 1.5, "the longest of three has no rank left"
    assert math.isclose(levels[0, 0, SE], 1.5 + 3 * Q / math.sqrt(8.0))


def test_only_so_many_ants_lay_as_there_are_ranks(updated: Callable[..., Any]) -> None:
    assert updated(RankBased(ranks=1), LONG, BENT, best=SHORT)[0, 0, E] == 1.5


def test_as_long_as_no_ant_has_arrived_nothing_is_laid(updated: Callable[..., Any]) -> None:
    assert np.unique(updated(RankBased(), None, None, best=None)).size == 1


def test_more_than_there_can_be_ants_is_refused() -> None:
    with pytest.raises(SettingsError, match=r"^update.ranks: expected a whole number from 1 to 100000; got 1000"):
        build(RankBased, {"ranks": 10**100}, "update.")


def test_its_preset_learns(learns: Callable[[str], bool]) -> None:
    assert learns("rank")
