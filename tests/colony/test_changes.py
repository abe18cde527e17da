"""Changes: which weights wait is known, and which patches have been changed, each once, in whatever order."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from samples import colony_on, problem_on

from acoexp import Grid
from acoexp.colony.changes import (
    PATCH,
    forget_change,
    forget_changes,
    let_wait,
    note_change,
    past_edge,
    patches,
    refresh,
    waits,
    weigh,
    weigh_all,
)
from acoexp.colony.state import Colony

GRID = Grid([[0] * 9] * 7)
EDGES = (7 + 2) * (9 + 2) * 8
ALPHA = 1.5


def known(colony: Colony) -> list[int]:
    """Return the changed patches, in order, after a look whether both ways to tell them agree."""
    listed = sorted(colony.changed[: colony.changed_count[0]].tolist())
    assert listed == colony.is_changed.nonzero()[0].tolist()
    return listed


def test_every_edge_is_in_one_patch() -> None:
    colony = colony_on(problem_on(GRID))
    assert patches(EDGES) == colony.is_changed.size == 13
    firsts = [patch * PATCH for patch in range(13)]
    assert [past_edge(colony, patch) for patch in range(13)] == [*firsts[1:], EDGES]


@settings(deadline=None)
@given(st.lists(st.integers(0, EDGES - 1) | st.just(-1), max_size=60))
def test_a_patch_is_changed_from_when_that_is_noted_until_it_is_forgotten(steps: list[int]) -> None:
    colony, expected = colony_on(problem_on(GRID)), set[int]()
    for step in steps:
        if step >= 0:
            note_change(colony, step)
            expected.add(step // PATCH)
        elif expected:
            place = len(expected) // 2
            expected.remove(int(colony.changed[place]))
            forget_change(colony, place)
        assert known(colony) == sorted(expected)
    forget_changes(colony)
    assert known(colony) == []


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
