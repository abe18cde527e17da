"""What a colony carries: parts, kernels and state belong together by their names."""

from __future__ import annotations

import numba
import pytest
from samples import colony_on, drawn, problem_on, room_of

from acoexp.colony.state import Colony, Kernels, Own
from acoexp.strategies.groups import STRATEGY_GROUPS


def test_every_group_has_a_kernel_but_the_heuristic_which_acts_before_the_first_cycle() -> None:
    assert {"heuristic", *Kernels._fields} == set(STRATEGY_GROUPS)


def test_each_kernel_finds_its_own_state_under_its_name() -> None:
    assert Own._fields == Kernels._fields


def test_what_differs_from_ant_to_ant_of_a_crowd_stands_last() -> None:
    """There ``walk`` replaces it, ant by ant."""
    assert Colony._fields[-1] == "untouched"


@pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")
def test_a_room_is_one_argument_of_the_compiled_loop() -> None:
    grid, _ = drawn("A.B")
    assert isinstance(numba.typeof(room_of(colony_on(problem_on(grid)))), numba.types.BaseNamedTuple)
