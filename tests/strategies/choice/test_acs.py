"""ACS's choice: mostly the heaviest move, else the roulette; the edge just taken decays towards tau0."""

from __future__ import annotations

import math

import numpy as np
import pytest
from samples import colony_on, drawn, number_of, problem_on

from acoexp.colony.pheromone import level, set_level
from acoexp.colony.random import seed_stream
from acoexp.colony.state import LOST, Colony
from acoexp.colony.tabu import touch
from acoexp.strategies.choice.acs import AntColonySystem

E, NE, N, NW, W, SW, S, SE = range(8)
TAU0 = 0.5


def in_the_middle(levels: dict[int, float]) -> tuple[Colony, int]:
    """Return a colony with these levels on the moves from the middle of a 3 x 3 map, and that cell."""
    problem = problem_on(drawn("a.. ... ..b", "free")[0], tau0=TAU0, alpha=1.0)
    colony, cell = colony_on(problem), number_of(problem, (1, 1))
    with np.errstate(over="ignore"):
        seed_stream(colony.random, np.uint64(1))
    for direction in range(8):
        set_level(colony, cell * 8 + direction, levels.get(direction, 1e-9))
    return colony, cell


def choose(colony: Colony, cell: int, q0: float, xi: float = 0.0) -> int:
    with np.errstate(over="ignore"):
        return int(AntColonySystem.kernel(colony, (q0, xi), 0, cell, 8))


def test_with_q0_of_one_the_heaviest_open_move_is_taken() -> None:
    colony, cell = in_the_middle({E: 1.0, S: 3.0, W: 2.0})
    assert {choose(colony, cell, 1.0) for _ in range(50)} == {S}
    touch(colony, cell + colony.offsets[S])
    assert choose(colony, cell, 1.0) == W


@pytest.mark.parametrize("q0", [0.0, 0.5, 0.9])
def test_else_the_roulette_decides(q0: float) -> None:
    colony, cell = in_the_middle({E: 1.0, S: 3.0})
    taken = [choose(colony, cell, q0) for _ in range(4000)]
    assert math.isclose(taken.count(S) / 4000, q0 + (1 - q0) * 0.75, abs_tol=0.03)


def test_the_edge_just_taken_decays_towards_tau0_and_no_other_does() -> None:
    colony, cell = in_the_middle({S: 3.0, W: 2.0})
    choose(colony, cell, 1.0, xi=0.1)
    assert math.isclose(level(colony, cell * 8 + S), 0.9 * 3.0 + 0.1 * TAU0)
    assert math.isclose(level(colony, cell * 8 + W), 2.0)


def test_an_ant_that_cannot_go_on_is_lost() -> None:
    colony, cell = in_the_middle({})
    for direction in range(8):
        touch(colony, cell + colony.offsets[direction])
    assert choose(colony, cell, 0.9) == LOST
