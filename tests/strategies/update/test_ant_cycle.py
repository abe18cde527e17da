"""Ant-Cycle (Eq. 18): what is left after evaporation, and Q / L from each ant that arrived."""

from __future__ import annotations

import math

import numpy as np
import pytest
from samples import colony_on, drawn, number_of, problem_on, trails_of

from acoexp.colony.changes import refresh
from acoexp.colony.pheromone import level
from acoexp.colony.state import Colony
from acoexp.strategies.update.ant_cycle import AntCycle
from acoexp.trial.workspace import new_trails

E, NE, N, NW, W, SW, S, SE = range(8)

GRID, _ = drawn("a.. ... ..b")
STRAIGHT, DIAGONAL, BENT = [E, E, S, S], [SE, SE], [E, SE, S]
"""Three ways over a map of 3 x 3 cells; the first and the last begin and end alike."""


def updated(*walks: list[int] | None, rho: float = 0.25, q: float = 6.0, tau0: float = 2.0) -> Colony:
    """Return a colony after one update with these ants' ways; None is a lost ant."""
    colony = colony_on(problem_on(GRID, ants=len(walks), rho=rho, q=q, tau0=tau0, alpha=1.0))
    raw = trails_of(colony, *walks)
    AntCycle.kernel(colony, (), raw, raw, new_trails(2, colony.allowed.size))
    refresh(colony)
    return colony


def level_at(colony: Colony, cell: tuple[int, int], direction: int) -> float:
    return float(level(colony, number_of(problem_on(GRID), cell) * 8 + direction))


def test_an_edge_that_nobody_walked_only_evaporates() -> None:
    colony = updated(STRAIGHT, DIAGONAL)
    assert level_at(colony, (1, 0), E) == 0.75 * 2.0


def test_each_ant_adds_q_over_the_length_of_its_way() -> None:
    colony = updated(STRAIGHT, DIAGONAL)
    assert math.isclose(level_at(colony, (0, 1), E), 1.5 + 6.0 / 4.0)
    assert math.isclose(level_at(colony, (1, 1), SE), 1.5 + 6.0 / (2.0 * math.sqrt(2.0)))


def test_ants_that_share_an_edge_add_up() -> None:
    colony = updated(STRAIGHT, BENT, STRAIGHT)
    bent = 6.0 / (2.0 + math.sqrt(2.0))
    assert math.isclose(level_at(colony, (0, 0), E), 1.5 + 1.5 + bent + 1.5)
    assert math.isclose(level_at(colony, (1, 2), S), 1.5 + 1.5 + bent + 1.5)
    assert math.isclose(level_at(colony, (0, 1), SE), 1.5 + bent)


def test_an_edge_is_strengthened_in_the_direction_of_travel_alone() -> None:
    colony = updated(STRAIGHT)
    assert level_at(colony, (0, 1), W) == 1.5


def test_a_lost_ant_deposits_nothing() -> None:
    colony, without = updated(None, DIAGONAL, None), updated(DIAGONAL)
    assert (colony.stored * colony.scale == without.stored * without.scale).all()


def test_a_lost_ants_steps_do_not_count() -> None:
    colony = colony_on(problem_on(GRID, ants=1, rho=0.0))
    raw = trails_of(colony, [E, S])
    raw.length[0] = np.inf
    before = colony.stored.copy()
    AntCycle.kernel(colony, (), raw, raw, new_trails(2, colony.allowed.size))
    assert (colony.stored == before).all()


@pytest.mark.parametrize(("rho", "left"), [(0.0, 2.0), (1.0, 0.0)])
def test_evaporation_may_take_nothing_or_all(rho: float, left: float) -> None:
    colony = updated(DIAGONAL, rho=rho)
    assert level_at(colony, (0, 0), E) == left
    assert math.isclose(level_at(colony, (0, 0), SE), left + 6.0 / (2.0 * math.sqrt(2.0)))


def test_weights_follow() -> None:
    colony = updated(STRAIGHT, BENT)
    edge = number_of(problem_on(GRID), (0, 0)) * 8
    assert math.isclose(colony.weight[edge + E] / colony.weight[edge + S], level_at(colony, (0, 0), E) / 1.5)
