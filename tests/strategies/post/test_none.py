"""No post-optimiser: paths stay as the ants walked them."""

from __future__ import annotations

import numpy as np
from samples import random_grid

from acoexp.registry.resolve import resolve
from acoexp.strategies.post.none import NoPost
from acoexp.trial.solver import Solver

GRID = random_grid(5, 12, 15, "no_cut")
SETTINGS = resolve("aco", {"post": NoPost(), "ants": 4, "iterations": 5})


def test_the_best_path_is_the_one_that_was_walked() -> None:
    best = Solver(GRID, SETTINGS).room_after(3).best
    assert best.steps[0] == best.steps[1] > 0
    assert np.array_equal(best.moves[0, : best.steps[0]], best.moves[1, : best.steps[1]])


def test_there_is_no_second_path_to_tell_of() -> None:
    result = Solver(GRID, SETTINGS).solve(3)
    assert result.path is not None
    assert result.raw_path is None
