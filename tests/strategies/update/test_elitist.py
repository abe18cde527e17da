"""The elitist ant system, by hand on a map of 3 x 3 cells: the best path is walked again by so many ants."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from acoexp.errors import SettingsError
from acoexp.parameters import build
from acoexp.strategies.update.elitist import Elitist

E, NE, N, NW, W, SW, S, SE = range(8)

LONG, SHORT = [E, E, S, S], [SE, SE]
Q = 6.0


def test_elitist_ants_walk_the_best_path_again(updated: Callable[..., Any]) -> None:
    levels = updated(Elitist(elitists=3), LONG, None, best=SHORT)
    assert math.isclose(levels[0, 0, E], 1.5 + Q / 4.0)
    assert math.isclose(levels[0, 0, SE], 1.5 + 3 * Q / math.sqrt(8.0))


def test_without_elitists_it_is_the_ant_system(updated: Callable[..., Any]) -> None:
    assert updated(Elitist(elitists=0), LONG, best=SHORT)[0, 0, SE] == 1.5


def test_as_long_as_no_ant_has_arrived_nothing_is_laid(updated: Callable[..., Any]) -> None:
    assert np.unique(updated(Elitist(), None, None, best=None)).size == 1


def test_more_than_there_can_be_ants_is_refused() -> None:
    with pytest.raises(
        SettingsError, match=r"^update.elitists: expected a whole number from 0 to 100000; got 1000"
    ):
        build(Elitist, {"elitists": 10**100}, "update.")


def test_its_preset_learns(learns: Callable[[str], bool]) -> None:
    assert learns("eas")
