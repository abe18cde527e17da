"""No diffusion: an ant that stands somewhere changes nothing."""

from __future__ import annotations

import numpy as np
from samples import colony_on, number_of, problem_on, random_grid

from acoexp.strategies.diffusion.none import NoDiffusion


def test_pheromone_and_random_numbers_stay_as_they_were() -> None:
    grid = random_grid(4, 6, 6, "free")
    problem, part = problem_on(grid), NoDiffusion()
    colony = colony_on(problem)
    before = [array.copy() for array in colony if isinstance(array, np.ndarray)]
    part.kernel(colony, part.prepare(problem), 0, number_of(problem, grid.start), 8)
    after = [array for array in colony if isinstance(array, np.ndarray)]
    assert all(np.array_equal(old, new) for old, new in zip(before, after, strict=True))
