"""Patches: which have been changed is known, each once, whatever is noted and forgotten in whatever order."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st
from samples import colony_on, problem_on

from acoexp import Grid
from acoexp.colony.patches import PATCH, forget_change, forget_changes, note_change, past_edge, patches
from acoexp.colony.state import Colony

GRID = Grid([[0] * 9] * 7)
EDGES = (7 + 2) * (9 + 2) * 8


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
