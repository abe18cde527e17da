"""The paper's double update: Eq. 18 with the ways as walked, then Eq. 19 with the optimised ones."""

from __future__ import annotations

import math

import numpy as np
import pytest
from samples import colony_on, drawn, number_of, problem_on, trails_of

from acoexp.colony.changes import refresh
from acoexp.colony.pheromone import level
from acoexp.colony.state import Colony
from acoexp.strategies.update.ant_cycle import AntCycle
from acoexp.strategies.update.dual_ant_cycle import DualAntCycle
from acoexp.trial.workspace import new_trails

E, NE, N, NW, W, SW, S, SE = range(8)

GRID, _ = drawn("a.. ... ..b")
WALKED, OPTIMISED = [E, E, S, S], [SE, SE]
ROOT8 = 2.0 * math.sqrt(2.0)


def updated(raw: list[list[int] | None], final: list[list[int] | None]) -> Colony:
    """Return a colony after one update: rho = 0.25, Q = 6, tau0 = 2."""
    colony = colony_on(problem_on(GRID, ants=len(raw), rho=0.25, q=6.0, tau0=2.0, alpha=1.0))
    best = new_trails(2, colony.allowed.size)
    DualAntCycle.kernel(colony, (), trails_of(colony, *raw), trails_of(colony, *final), best)
    refresh(colony)
    return colony


def level_at(colony: Colony, cell: tuple[int, int], direction: int) -> float:
    return float(level(colony, number_of(problem_on(GRID), cell) * 8 + direction))


def test_pheromone_evaporates_twice() -> None:
    assert math.isclose(level_at(updated([WALKED], [OPTIMISED]), (1, 0), E), 0.75 * 0.75 * 2.0)


def test_what_the_walked_way_got_evaporates_once_and_what_the_optimised_one_got_does_not() -> None:
    colony = updated([WALKED], [OPTIMISED])
    assert math.isclose(level_at(colony, (0, 0), E), 0.75 * (0.75 * 2.0 + 6.0 / 4.0))
    assert math.isclose(level_at(colony, (0, 0), SE), 0.75 * 0.75 * 2.0 + 6.0 / ROOT8)


def test_an_edge_of_both_ways_gets_both() -> None:
    colony = updated([OPTIMISED], [OPTIMISED])
    assert math.isclose(level_at(colony, (1, 1), SE), 0.75 * (0.75 * 2.0 + 6.0 / ROOT8) + 6.0 / ROOT8)


def test_every_ant_counts_with_both_its_ways() -> None:
    colony = updated([WALKED, OPTIMISED], [OPTIMISED, OPTIMISED])
    assert math.isclose(level_at(colony, (0, 0), SE), 0.75 * (0.75 * 2.0 + 6.0 / ROOT8) + 2 * 6.0 / ROOT8)


def test_a_lost_ant_deposits_nothing_in_either() -> None:
    colony, without = updated([None, WALKED], [None, OPTIMISED]), updated([WALKED], [OPTIMISED])
    assert (colony.stored * colony.scale == without.stored * without.scale).all()


def test_weights_follow() -> None:
    colony = updated([WALKED], [OPTIMISED])
    edge = number_of(problem_on(GRID), (0, 0)) * 8
    ratio = level_at(colony, (0, 0), E) / level_at(colony, (0, 0), SE)
    assert math.isclose(colony.weight[edge + E] / colony.weight[edge + SE], ratio)


@pytest.mark.parametrize("walk", [WALKED, OPTIMISED])
def test_without_a_post_optimiser_it_is_ant_cycle_done_twice(walk: list[int]) -> None:
    colony = colony_on(problem_on(GRID, ants=1, rho=0.25, q=6.0, tau0=2.0, alpha=1.0))
    raw = trails_of(colony, walk)
    for _ in range(2):
        AntCycle.kernel(colony, (), raw, raw, new_trails(2, colony.allowed.size))
    twice = updated([walk], [walk])
    np.testing.assert_allclose(twice.stored * twice.scale, colony.stored * colony.scale, rtol=1e-14)
