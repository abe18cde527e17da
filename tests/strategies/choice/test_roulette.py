"""The roulette takes open moves in proportion to their weights, and nothing else."""

from __future__ import annotations

import random

import numba
import numpy as np
import pytest
from reference import Random
from samples import colony_on, drawn, number_of, problem_on
from scipy.stats import chisquare

from acoexp import Grid
from acoexp.colony.state import LOST, Colony
from acoexp.colony.tabu import touch
from acoexp.strategies.choice.roulette import Roulette

DRAWS = 20_000 if not numba.config.DISABLE_JIT else 2_000

E, NE, N, NW, W, SW, S, SE = range(8)
CENTRE = (1, 1)


def colony_with(weights: dict[int, float], drawing: str = "a.. ... ..b") -> tuple[Colony, int]:
    """Return a colony whose moves from the middle of a 3 x 3 map have these weights, and that cell."""
    grid, _ = drawn(drawing, "free")
    problem = problem_on(grid)
    colony, cell = colony_on(problem), number_of(problem, CENTRE)
    for direction in range(8):
        if colony.allowed[cell] >> direction & 1:
            colony.weight[cell * 8 + direction] = weights.get(direction, 0.0)
    return colony, cell


def spun(colony: Colony, cell: int, times: int) -> list[int]:
    with np.errstate(over="ignore"):
        return [int(Roulette.kernel(colony, (), 0, cell, 8)) for _ in range(times)]


def counts(moves: list[int]) -> list[int]:
    return np.bincount(moves, minlength=9).tolist()


def test_moves_are_taken_in_proportion_to_their_weights() -> None:
    weights = {E: 1.0, NE: 2.0, N: 0.5, NW: 4.0, W: 1.0, SW: 0.25, S: 3.0, SE: 8.0}
    colony, cell = colony_with(weights)
    taken = counts(spun(colony, cell, DRAWS))
    assert taken[LOST] == 0
    expected = np.array([weights[d] for d in range(8)]) / sum(weights.values()) * DRAWS
    assert chisquare(taken[:8], expected).pvalue > 0.001


@pytest.mark.parametrize("factor", [1e-250, 1e-30, 1.0, 1e30, 1e289])
def test_a_common_factor_of_all_weights_does_not_matter(factor: float) -> None:
    weights = {d: 1.0 + d for d in range(8)}
    plain, cell = colony_with(weights)
    scaled, _ = colony_with({d: weight * factor for d, weight in weights.items()})
    assert spun(scaled, cell, 300) == spun(plain, cell, 300)


def test_one_number_decides_and_the_moves_lie_side_by_side_from_east_on() -> None:
    seed = random.Random(4)
    for _ in range(300 if DRAWS > 2_000 else 50):
        weights = {d: seed.choice([0.0, 1.0, seed.random(), 10 ** seed.uniform(-9, 9)]) for d in range(8)}
        weights[seed.randrange(8)] = 1.0
        colony, cell = colony_with(weights)
        drawn_number = Random(0).uniform() * sum(weights.values())
        running = np.cumsum([weights[d] for d in range(8)])
        assert spun(colony, cell, 1) == [int(np.argmax(running > drawn_number))]


@pytest.mark.parametrize("weight", [1.0, 1e-9, 5e-324])
def test_a_move_of_no_weight_is_never_taken(weight: float) -> None:
    for heavy in range(8):
        colony, cell = colony_with({heavy: weight})
        assert set(spun(colony, cell, 50)) == {heavy}


def test_not_even_by_the_number_0() -> None:
    for heavy in range(8):
        colony, cell = colony_with({heavy: 1.0})
        colony.random[:] = [0, 5, 6, 0]  # the state before a 0
        assert spun(colony, cell, 1) == [heavy]


def test_where_an_ant_has_been_it_does_not_go_again() -> None:
    colony, cell = colony_with(dict.fromkeys(range(8), 1.0))
    for direction in (E, NW, S):
        touch(colony, cell + colony.offsets[direction])
    taken = counts(spun(colony, cell, DRAWS))
    assert [taken[d] for d in (E, NW, S, LOST)] == [0, 0, 0, 0]
    assert chisquare([taken[d] for d in (NE, N, W, SW, SE)]).pvalue > 0.001


def test_the_heaviest_move_is_not_taken_where_the_ant_has_been() -> None:
    colony, cell = colony_with({E: 1e-300, SE: 1e280})
    touch(colony, cell + colony.offsets[SE])
    assert set(spun(colony, cell, 100)) == {E}


def test_obstacles_are_never_entered() -> None:
    colony, cell = colony_with(dict.fromkeys(range(8), 1.0), "a## #.# ..b")
    assert set(spun(colony, cell, 500)) == {NW, SW, S, SE}


def test_where_every_weight_underflows_all_open_moves_are_as_likely() -> None:
    colony, cell = colony_with({}, "a.# ... ..b")
    touch(colony, cell + colony.offsets[W])
    taken = counts(spun(colony, cell, DRAWS))
    still_open = [d for d in range(8) if colony.allowed[cell] >> d & 1 and d != W]
    assert chisquare([taken[d] for d in still_open]).pvalue > 0.001
    assert sum(taken[d] for d in still_open) == DRAWS


def test_where_every_weight_underflows_a_second_number_picks_one_of_the_open_moves() -> None:
    colony, cell = colony_with({})
    touch(colony, cell + colony.offsets[NE])
    reference, still_open = Random(0), [E, N, NW, W, SW, S, SE]
    for move in spun(colony, cell, 100):
        reference.uniform()
        assert move == still_open[int(reference.uniform() * 7)]


def test_an_ant_with_no_open_move_is_lost_after_one_number() -> None:
    colony, cell = colony_with(dict.fromkeys(range(8), 1.0))
    for offset in colony.offsets:
        touch(colony, cell + offset)
    assert spun(colony, cell, 1) == [LOST]
    reference = Random(0)
    reference.uniform()
    assert colony.random.tolist() == reference.words


def test_it_leaves_pheromone_and_tabu_as_they_are() -> None:
    colony, cell = colony_with(dict.fromkeys(range(8), 1.0))
    before = [array.copy() for array in (colony.stored, colony.weight, colony.scale, colony.untouched)]
    spun(colony, cell, 20)
    for array, old in zip((colony.stored, colony.weight, colony.scale, colony.untouched), before, strict=True):
        assert (array == old).all()


def test_weights_are_pheromone_to_the_alpha_times_eta_to_the_beta() -> None:
    problem = problem_on(Grid(np.zeros((3, 3))), alpha=2.0, beta=3.0, tau0=1.0)
    eta = np.ones((3, 3, 8))
    eta[1, 1, E] = 2.0
    colony = colony_on(problem, eta)
    taken = counts(spun(colony, number_of(problem, CENTRE), DRAWS))
    assert chisquare(taken[:8], np.array([8, 1, 1, 1, 1, 1, 1, 1]) / 15 * DRAWS).pvalue > 0.001
