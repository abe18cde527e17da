"""Two ends: ants that set out from both meet on the way, and each end learns of every path."""

from __future__ import annotations

from typing import Any

import numba
import numpy as np
import pytest
from samples import random_grid

import acoexp
from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

pytestmark = pytest.mark.skipif(
    not numba.config.DISABLE_JIT,  # type: ignore[attr-defined]
    reason="each would have to be compiled; test_loop holds one that is against the reference",
)

CORRIDOR = Grid([[0, 0, 0, 0, 0, 0]], start=(0, 0), goal=(0, 5))
FORK = Grid([[0, 0, 0, 0], [1, 1, 1, 0], [0, 0, 0, 0]], start=(0, 1), goal=(2, 1), moves="no_cut")
"""The way leads round; beside each end is a dead end."""


def room_after(grid: Grid, algo: str = "aco", **settings: Any) -> Any:
    """Return what the colonies at both ends worked on, after a trial."""
    return Solver(grid, resolve(algo, {"order": "two_ended", "iterations": 3, **settings})).room_after(1)


def test_a_pair_meets_in_the_middle_and_the_path_is_whole() -> None:
    room = room_after(CORRIDOR, ants=2)
    assert room.raw.moves[:, :5].tolist() == [[0] * 5] * 2
    assert room.facing.raw.moves[:, :5].tolist() == [[4] * 5] * 2
    assert room.made.tolist() == [5, 5]  # three from the start, two from the goal


def test_who_is_lost_alone_is_found_by_the_other() -> None:
    """Without steps back half of the ants at each end are lost; only where both are there is no path."""
    result = acoexp.solve(FORK, "aco", 0, order="two_ended", ants=40, iterations=20, alpha=0.0, beta=0.0)
    assert result.path is not None
    assert 0.1 < result.lost_ants.sum() / 800 < 0.4


def test_with_steps_back_every_pair_meets_and_their_moves_back_count() -> None:
    settings: Any = {"order": "two_ended", "dead_end": "step_back", "iterations": 5, "alpha": 0.0, "beta": 0.0}
    result = acoexp.solve(FORK, "aco", 0, **settings)
    assert result.lost_ants.sum() == 0
    assert result.length == result.optimum
    assert result.ant_steps > 50 * sum(result.optimum_pair)


@pytest.mark.parametrize("algo", ["aco", "rank"])
def test_what_is_laid_at_one_end_is_laid_backwards_at_the_other(algo: str) -> None:
    grid = random_grid(3, 8, 11, "no_squeeze")
    room = room_after(grid, algo, dead_end="step_back")
    colony, facing = room.colony, room.facing.colony
    cells, directions = np.nonzero(np.unpackbits(colony.allowed[:, None], axis=1, bitorder="little"))
    there = colony.stored[cells * 8 + directions] * colony.scale[0]
    back = facing.stored[(cells + colony.offsets[directions]) * 8 + (directions ^ 4)] * facing.scale[0]
    assert len(np.unique(there)) > 2
    np.testing.assert_allclose(there, back, rtol=1e-12)


def test_nothing_is_left_of_a_walk() -> None:
    room = room_after(random_grid(5, 9, 9, "free"), dead_end="step_back")
    assert (room.facing.pair.place == -1).all()
    assert (room.colony.untouched == 1.0).all()
    assert (room.facing.colony.untouched == 1.0).all()


def test_an_end_is_no_partys_own() -> None:
    """Start and goal may change places: on a map that looks alike from both, what is found is alike."""
    assert acoexp.solve(CORRIDOR, "aco", order="two_ended", iterations=2).length == 5.0
    way_back = Grid(CORRIDOR.obstacles, start=CORRIDOR.goal, goal=CORRIDOR.start)
    assert acoexp.solve(way_back, "aco", order="two_ended", iterations=2).length == 5.0
