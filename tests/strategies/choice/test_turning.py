"""The turning penalty: the further a move turns from the one before, the less likely it is."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from samples import colony_on, drawn, number_of, problem_on

import acoexp
from acoexp.colony.random import seed_stream
from acoexp.colony.state import LOST, NO_WAY_HERE
from acoexp.colony.tabu import touch
from acoexp.strategies.choice.turning import Turning

E, NE, N, NW, W, SW, S, SE = range(8)


def taken(penalty: float, came: int, times: int = 6000, tabu: tuple[int, ...] = ()) -> np.ndarray:
    """Return how often each move is taken from the middle of an empty 3 x 3 map, all weights alike; LOST last."""
    problem = problem_on(drawn("a.. ... ..b", "free")[0])
    colony, cell = colony_on(problem), number_of(problem, (1, 1))
    own = Turning(penalty=penalty).prepare(problem)
    for direction in tabu:
        touch(colony, cell + colony.offsets[direction])
    with np.errstate(over="ignore"):
        seed_stream(colony.random, np.uint64(7))
        moves = [int(Turning.kernel(colony, own, 0, cell, came)) for _ in range(times)]
    return np.bincount(moves, minlength=9) / times


def test_each_eighth_of_a_turn_makes_a_move_less_likely_by_one_factor() -> None:
    share = taken(0.7, came=E)
    for one, further in ((E, NE), (NE, N), (E, SE), (SE, S)):
        assert math.isclose(share[further] / share[one], math.exp(-0.7), rel_tol=0.12)


def test_left_and_right_are_alike() -> None:
    share = taken(0.5, came=NE)
    assert math.isclose(share[N], share[E], rel_tol=0.15)


def test_the_first_move_is_free_and_no_penalty_is_the_roulette() -> None:
    for share in (taken(5.0, came=NO_WAY_HERE), taken(0.0, came=E)):
        assert np.allclose(share[:8], 1 / 8, atol=0.02)


def test_tabu_moves_are_not_taken_and_a_penalty_may_underflow() -> None:
    share = taken(50.0, came=E, times=100, tabu=(E, NE, SE, N, S, NW, SW))
    assert share[W] == 1.0
    assert taken(0.5, came=E, times=10, tabu=tuple(range(8)))[LOST] == 1.0


@pytest.mark.slow_without_jit
def test_paths_have_fewer_bends() -> None:
    def bends(penalty: float) -> float:
        results = acoexp.solve_many(
            "env1", "aco", range(60), choice={"name": "turning", "penalty": penalty}, iterations=60
        )
        return float(np.mean([sum(a != b for a, b in pairwise(r.moves.tolist())) for r in results]))

    assert bends(1.0) < bends(0.0)
