"""Weights: which of them wait is known, and that none does once they are refreshed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from samples import colony_on, problem_on

from acoexp import Grid
from acoexp.colony.state import Colony
from acoexp.colony.weights import let_wait, refresh, waits, weigh, weigh_all

ALPHA = 1.5


def some_colony() -> tuple[Colony, NDArray[np.float64]]:
    """Return a colony whose weights are not those of what is stored, and what these would be."""
    grid = Grid([[0, 0, 0], [0, 0, 0]])
    draw = np.random.default_rng(0)
    colony = colony_on(problem_on(grid, alpha=ALPHA), draw.uniform(0.1, 1.0, (*grid.shape, 8)))
    colony.stored[:] = draw.uniform(0.1, 1.0, colony.stored.size)
    return colony, colony.stored**ALPHA * colony.desirability


def test_one_edge_is_weighed_or_all_are() -> None:
    colony, expected = some_colony()
    before = colony.weight.copy()
    edge = int(expected.argmax())
    weigh(colony, edge)
    np.testing.assert_allclose(colony.weight[edge], expected[edge])
    assert (np.delete(colony.weight, edge) == np.delete(before, edge)).all()
    weigh_all(colony)
    np.testing.assert_allclose(colony.weight, expected)


def test_an_edge_waits_once_and_until_it_is_refreshed() -> None:
    colony, expected = some_colony()
    edge = int(expected.argmax())
    for _ in range(2):
        let_wait(colony, edge)
    assert waits(colony, edge)
    assert colony.stale[: colony.stale_count[0]].tolist() == [edge]
    refresh(colony)
    assert not waits(colony, edge)
    assert colony.stale_count[0] == 0
    np.testing.assert_allclose(colony.weight[edge], expected[edge])


def test_an_edge_that_waits_is_one_that_has_changed() -> None:
    colony, expected = some_colony()
    let_wait(colony, int(expected.argmax()))
    assert colony.changed_count[0] == 1
