"""The MAX-MIN ant system, by hand on a map of 3 x 3 cells: one path gets pheromone, and all levels have limits."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from samples import problem_on, random_grid

from acoexp import SettingsError, solve
from acoexp.strategies.update.max_min import CHOICES, MaxMin

E, NE, N, NW, W, SW, S, SE = range(8)

LONG, SHORT, BENT = [E, E, S, S], [SE, SE], [E, SE, S]
Q = 6.0


@pytest.mark.parametrize("whose", ["cycle", "run"])
def test_only_one_path_gets_pheromone(whose: str, updated: Callable[..., Any]) -> None:
    levels = updated(MaxMin(p_best=0.9, best=whose), LONG, BENT, best=SHORT)
    edge, laid = {"cycle": (E, Q / (2.0 + math.sqrt(2.0))), "run": (SE, Q / math.sqrt(8.0))}[whose]
    assert math.isclose(levels[0, 0, edge], 1.5 + laid)
    assert math.isclose(levels[0, 0, E + SE - edge], 1.5)
    assert math.isclose(levels[0, 1, E], 1.5), "the longer ant lays nothing"


@pytest.mark.parametrize("rho", [0.02, 0.25, 0.9])
def test_every_level_stays_between_limits_that_follow_from_the_best_path(
    rho: float, updated: Callable[..., Any]
) -> None:
    levels = updated(MaxMin(p_best=0.05), SHORT, best=SHORT, rho=rho)
    highest = Q / (rho * math.sqrt(8.0))
    root = 0.05 ** (1 / 2)
    lowest = min(highest, highest * (1 - root) / ((CHOICES - 1) * root))
    assert levels.min() >= lowest * (1 - 1e-12)
    assert levels.max() <= highest * (1 + 1e-12)


def test_it_begins_at_a_level_that_no_limit_exceeds() -> None:
    grid = random_grid(3, 12, 12, "no_squeeze")
    problem = problem_on(grid, rho=0.1, q=2.0)
    assert MaxMin().initial(problem) >= 2.0 / (0.1 * grid.optimum)


@pytest.mark.parametrize("rho", [0.0, 1e-300, 9e-7])
def test_where_nothing_evaporates_there_are_no_limits_and_it_says_so(rho: float) -> None:
    said = r"^rho: expected a number from 1e-06 to 1 with update=max_min, whose limits are Q / \(rho L\*\); got "
    with pytest.raises(SettingsError, match=said + f"{rho:g}$"):
        solve("fig13", "mmas", rho=rho)


def test_as_long_as_no_ant_has_arrived_nothing_is_laid(updated: Callable[..., Any]) -> None:
    assert np.unique(updated(MaxMin(best="run"), None, None, best=None)).size == 1


def test_its_preset_learns(learns: Callable[[str], bool]) -> None:
    assert learns("mmas")
