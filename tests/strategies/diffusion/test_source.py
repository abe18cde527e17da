"""What diffuses may be the pheromone of the edge along the force, or what another reading of phi(i) says."""

from __future__ import annotations

import math
import random
from typing import Any

import numpy as np
import pytest
from reference import Colony as Reference
from reference import Pheromone, diffuse_gaussian, diffuse_luo_wu, forces_of, moves_of
from samples import colony_on, number_of, problem_on, random_grid

from acoexp import Grid
from acoexp.colony.pheromone import level, set_level
from acoexp.colony.state import NO_WAY_HERE
from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.strategies.diffusion.luo_wu import LuoWu
from acoexp.strategies.diffusion.source import SOURCES

E, NE, N, NW, W, SW, S, SE = range(8)
STRAIGHT = 1.0 - math.sqrt(2.0) / 3.0
PLUS = Grid([[0, 0, 0], [0, 0, 0], [0, 0, 0]], start=(1, 0), goal=(1, 2))
"""In the middle the force points east; eight edges lead there, and eight away."""


def gained(source: str, came: int = NO_WAY_HERE, pheromone: str = "edges", **levels: float) -> float:
    """Let an ant stand in the middle, gamma = 0.5: what the edge east gains, the share of it aside.

    The levels given are those of the edges between the middle and its neighbours: ``e_in`` leads in from the east.
    """
    problem, part = problem_on(PLUS, pheromone=pheromone), Gaussian(gamma=0.5, source=source)
    colony, middle = colony_on(problem), number_of(problem, (1, 1))
    for name, amount in levels.items():
        direction = ["e", "ne", "n", "nw", "w", "sw", "s", "se"].index(name.partition("_")[0])
        leads_in = (middle + colony.offsets[direction]) * 8 + (direction + 4) % 8
        set_level(colony, leads_in if name.endswith("_in") else middle * 8 + direction, amount)
    before = level(colony, middle * 8 + E)
    part.kernel(colony, part.prepare(problem), 0, middle, came)
    return float((level(colony, middle * 8 + E) - before) / (0.5 * STRAIGHT))


def test_force_edge_is_the_edge_that_gets_it() -> None:
    assert gained("force_edge", E, e=7.0, w_in=3.0) == pytest.approx(7.0)


def test_walked_edge_is_the_edge_by_which_the_ant_came() -> None:
    assert gained("walked_edge", E, e=7.0, w_in=3.0) == pytest.approx(3.0)
    assert gained("walked_edge", SW, e=7.0, w_in=3.0, ne_in=5.0) == pytest.approx(5.0)


def test_on_the_start_no_edge_was_walked_and_nothing_diffuses() -> None:
    assert gained("walked_edge", NO_WAY_HERE, e=7.0, w_in=3.0) == 0.0


def test_sum_in_adds_up_the_edges_that_lead_here() -> None:
    assert gained("sum_in", E, e=7.0, w_in=3.0, ne_in=5.0) == pytest.approx(6 + 3 + 5)


def test_mean_out_and_max_out_look_at_the_edges_that_leave() -> None:
    assert gained("mean_out", E, w=3.0, ne=5.0, w_in=100.0) == pytest.approx((6 + 3 + 5) / 8)
    assert gained("max_out", E, w=3.0, ne=5.0, w_in=100.0) == pytest.approx(5.0)


def test_with_pheromone_on_cells_the_walked_edge_has_that_of_the_ants_own_cell() -> None:
    assert gained("walked_edge", E, pheromone="cells", s_in=4.0) == pytest.approx(4.0)


@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize(
    ("kind", "diffuse", "algo"), [(Gaussian, diffuse_gaussian, "pd"), (LuoWu, diffuse_luo_wu, "pf")]
)
def test_on_every_cell_it_does_what_the_reference_does(
    kind: type[Any], diffuse: Any, algo: str, source: str
) -> None:
    grid, draw = random_grid(13, 9, 12, "no_squeeze", density=0.3), random.Random(0)
    problem, part = problem_on(grid), kind(gamma=0.4, source=source)
    colony, own = colony_on(problem), part.prepare(problem)
    reference, moves = Reference(algo, gamma=0.4, source=source), moves_of(grid)
    tau = Pheromone(moves, "edges", 1.0)
    for cell, direction in tau.place:
        tau[cell, direction] = amount = draw.uniform(0.5, 2.0)
        set_level(colony, number_of(problem, cell) * 8 + direction, amount)
    for cell, force in forces_of(grid, reference).items():
        came = draw.choice([None, *((d + 4) % 8 for d in moves[cell])])
        diffuse(tau, cell, came, force, reference)
        part.kernel(colony, own, 0, number_of(problem, cell), np.int64(NO_WAY_HERE if came is None else came))
    for cell, direction in tau.place:
        stored = level(colony, number_of(problem, cell) * 8 + direction)
        assert math.isclose(stored, tau[cell, direction], rel_tol=1e-12)
