"""Trials on one map after the other are the trials of ``acoexp.solve_many``."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp import Grid, solve_many
from acoexp.grid import MOVE_RULES
from acoexp.reconstruct.colonies import Colonies
from acoexp.reconstruct.layout import paint

MAPS = [paint(np.array(rectangles)) for rectangles in ([[2, 2, 9, 12], [11, 9, 17, 18]], [[4, 0, 6, 12]])]


@pytest.mark.slow_without_jit
@pytest.mark.parametrize("moves", MOVE_RULES)
def test_trials_are_those_of_aco_whatever_map_was_before(moves: str) -> None:
    colonies = Colonies(moves, 20)
    for obstacles in (*MAPS, MAPS[0]):
        found = colonies.run(obstacles, range(5))
        results = solve_many(Grid(obstacles, moves=moves), algo="aco", seeds=range(5), iterations=20)
        for key in found._fields:
            assert getattr(found, key).tolist() == [getattr(result, key) for result in results]


def test_joined_outcomes_are_those_of_both() -> None:
    colonies = Colonies("free", 1)
    first, second = (colonies.run(MAPS[0], seeds) for seeds in ([1], [2, 3]))
    both = colonies.run(MAPS[0], [1, 2, 3])
    assert first.joined(second).size == 3
    assert all((a == b).all() for a, b in zip(first.joined(second), both, strict=True))
