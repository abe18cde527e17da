"""Steps: which answers of a choice are moves, and which give the last move back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from acoexp.colony.state import BACK, LOST, NO_WAY_HERE
from acoexp.colony.steps import came_by, idle, is_allowed, leaves
from acoexp.trial.workspace import new_trails

EAST_AND_NORTH = np.uint8(0b101)


@pytest.mark.parametrize("move", range(8))
def test_a_move_is_allowed_if_its_bit_is_set(move: int) -> None:
    assert bool(is_allowed(EAST_AND_NORTH, move)) == (move in (0, 2))


@pytest.mark.parametrize("answer", [LOST, BACK, -1, 10, 64, 256, 258, 2**32, -(2**40)])
def test_what_is_no_direction_is_no_move(answer: int) -> None:
    assert not is_allowed(np.uint8(255), answer)


@pytest.mark.parametrize(("answer", "steps_back", "is_so"), [(BACK, False, True), (LOST, True, True),
                                                             (LOST, False, False), (3, True, False)])  # fmt: skip
def test_an_ant_gives_its_move_back_if_the_choice_says_so_or_if_it_is_stuck_and_may(
    answer: int, steps_back: bool, is_so: bool
) -> None:
    assert bool(leaves(answer, steps_back)) == is_so


def test_an_ant_came_by_its_last_move_or_stands_on_the_start() -> None:
    trails: Any = new_trails(1, 9)
    trails.moves[0, :2] = 3, 6
    assert [came_by(trails, 0, steps) for steps in (0, 1, 2)] == [NO_WAY_HERE, 3, 6]


def test_what_is_idle_succeeds() -> None:
    assert idle(1, "two", None) is True
