"""A worker's memory: what it has alone, what it shares, and what has to be restored before each trial."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from samples import problem_on, random_grid

from acoexp import SettingsError
from acoexp.colony.state import Own, Prepared
from acoexp.grid.moves import DIRECTIONS
from acoexp.trial import workspace as module
from acoexp.trial.workspace import End, Workspace, direction_offsets, new_workspace, offset_directions

GRID = random_grid(1, 6, 9, "free")
NONE = Own((), (), (), ())
STOP = np.zeros(1, dtype=np.uint8)


def workspace_with(own: Own = NONE, has_post: bool = False, **scalars: Any) -> Workspace:
    problem = problem_on(GRID, **scalars)
    desirability = problem.per_edge(problem.allowed_edges().astype(np.float64), border=0.0)
    return new_workspace([End(problem, Prepared(desirability, np.ones(1), own))], has_post, STOP)


def test_a_part_writes_to_copies_of_its_own_and_each_is_known_with_what_it_was() -> None:
    marks = np.arange(3.0)
    workspace = workspace_with(NONE._replace(diffusion=(marks, 0.5)))
    mine, half = workspace.room.own.diffusion
    mine[:] = 7.0
    assert (marks.tolist(), half) == ([0.0, 1.0, 2.0], 0.5)
    assert [(array is mine, pristine is marks) for array, pristine in workspace.to_restore] == [(True, True)]


def test_what_a_part_may_only_read_is_shared_and_needs_no_restoring() -> None:
    table = np.arange(3.0)
    table.flags.writeable = False
    workspace = workspace_with(NONE._replace(choice=(table,)))
    assert workspace.room.own.choice[0] is table
    assert workspace.to_restore == []


@pytest.mark.parametrize(("order", "crowded"), [("in_turn", False), ("lock_step", True)])
def test_there_is_a_crowd_where_ants_walk_together(order: str, crowded: bool) -> None:
    assert (workspace_with(order=order).room.crowd is not None) == crowded


@pytest.mark.parametrize("has_post", [True, False])
def test_paths_as_walked_are_kept_where_they_are_optimised(has_post: bool) -> None:
    room = workspace_with(has_post=has_post).room
    assert (room.final is not room.raw) == has_post


def test_what_the_memory_does_not_suffice_for_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    def too_much(ants: int, cells: int) -> None:
        raise MemoryError

    monkeypatch.setattr(module, "new_trails", too_much)
    with pytest.raises(SettingsError, match=r"^ants: .* the memory suffices; got 17 on a map of 88 cells$"):
        workspace_with(ants=17)


@pytest.mark.parametrize("direction", range(8))
def test_a_direction_leads_to_a_neighbour_and_its_offset_back_to_it(direction: int) -> None:
    width, (down, right) = 11, DIRECTIONS[direction]
    offset = direction_offsets(width)[direction]
    assert offset == down * width + right
    assert offset_directions(width)[offset + width + 1] == direction


def test_a_jump_to_no_neighbour_has_no_direction() -> None:
    assert (offset_directions(11) == 8).sum() == 2 * 11 + 3 - 8
