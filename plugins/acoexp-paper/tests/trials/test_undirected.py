"""Pheromone without a direction."""

from __future__ import annotations

import numpy as np
import pytest
from acoexp_paper.trials.undirected import UndirectedAntCycle, UndirectedDualAntCycle

from acoexp.grid.grid import Grid
from acoexp.grid.moves import DIRECTIONS
from acoexp.registry.resolve import resolve
from acoexp.strategies.part import Update
from acoexp.trial.solver import Solver

YARD = Grid(np.array([[0, 0, 0], [0, 1, 0], [0, 0, 0]]), moves="no_cut")


@pytest.mark.slow_without_jit
@pytest.mark.parametrize(("algo", "part"), [("aco", UndirectedAntCycle()), ("pdg", UndirectedDualAntCycle())])
def test_both_ways_of_an_edge_have_the_same(algo: str, part: Update) -> None:
    settings = resolve(algo, {"update": part, "iterations": 3, "ants": 4, "diffusion": "none"})
    levels = Solver(YARD, settings).pheromone(0)
    walked = 0
    for row, col, direction in np.argwhere(~np.isnan(levels)).tolist():
        down, right = DIRECTIONS[direction]
        way, back = levels[row, col, direction], levels[row + down, col + right, direction ^ 4]
        assert way == pytest.approx(back)
        walked += way > 1.1 * np.nanmin(levels)
    assert 8 <= walked <= 16
