"""Descent: a move counts by how far down a field of distances it leads."""

from __future__ import annotations

import math

import numpy as np
import pytest

from acoexp.strategies.heuristic.descent import descent

FIELD = np.array([[3.0, 1.5, np.inf], [4.0, 2.0, 0.0]])


@pytest.mark.parametrize("strength", [0.0, 0.5, 3.0])
@pytest.mark.parametrize(("cell", "direction", "down"), [((0, 0), 0, 1.5), ((1, 0), 1, 2.5), ((0, 1), 7, 1.5),
                                                         ((1, 1), 3, -1.0), ((1, 2), 4, -2.0)])  # fmt: skip
def test_it_is_the_exponential_of_how_far_a_move_leads_down(
    cell: tuple[int, int], direction: int, down: float, strength: float
) -> None:
    assert descent(FIELD, strength)[cell][direction] == pytest.approx(math.exp(strength * down), rel=1e-12)


@pytest.mark.parametrize(("cell", "direction"), [((0, 1), 0), ((0, 2), 4), ((0, 0), 2), ((1, 2), 0), ((1, 2), 7)])
def test_to_or_from_where_nothing_is_known_it_is_one(cell: tuple[int, int], direction: int) -> None:
    assert descent(FIELD, 2.0)[cell][direction] == 1.0
