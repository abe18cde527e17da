"""The background: what is done to it as one number is what a look at every edge would have done."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from samples import colony_on, problem_on

from acoexp import Grid
from acoexp.colony import pheromone
from acoexp.colony.background import NONE, into_bounds, spread, without
from acoexp.colony.changes import refresh
from acoexp.colony.state import Colony

GRID = Grid([[0] * 9] * 7)
FAR = 50 * 8
"""An edge in a patch of its own."""

EDGES = [40 * 8, 40 * 8 + 1, FAR]


def some_colony(**scalars: Any) -> Colony:
    return colony_on(problem_on(GRID, **scalars), np.random.default_rng(0).uniform(0.1, 1.0, (*GRID.shape, 8)))


def levels(colony: Colony) -> NDArray[np.float64]:
    return colony.stored * colony.scale[0]


@pytest.mark.parametrize(
    ("level", "inside"), [(0.5, 1.0), (1.0, 1.0), (1.7, 1.7), (2.0, 2.0), (3.0, 2.0)], ids=str
)
def test_a_level_is_brought_to_the_bound_that_it_is_beyond(level: float, inside: float) -> None:
    assert into_bounds(level, 1.0, 2.0) == inside


@settings(deadline=None)
@given(
    st.lists(
        st.tuples(st.sampled_from([40 * 8, 40 * 8 + 1, FAR]), st.floats(0.0, 5.0), st.floats(0.1, 0.9)),
        max_size=25,
    ),
    st.sampled_from([0.3, 1.0, 1.1, 4.0]),
)
def test_cycle_after_cycle_of_limits_gives_the_levels_of_a_plain_clip(
    cycles: list[tuple[int, float, float]], alpha: float
) -> None:
    colony, plain = some_colony(alpha=alpha, tau0=3.0), np.full((7 + 2) * (9 + 2) * 8, 3.0)
    for edge, amount, share in cycles:
        lowest, highest = 0.1 + share / 10, 1.0 + share
        pheromone.evaporate(colony, 0.4)
        pheromone.deposit(colony, edge, amount)
        pheromone.clamp(colony, lowest, highest)
        plain *= 0.6
        plain[edge] += amount
        plain = plain.clip(lowest, highest)
        np.testing.assert_allclose(levels(colony), plain, rtol=1e-9)
        expected = colony.stored**alpha * colony.desirability
        np.testing.assert_allclose(colony.weight, expected, rtol=1e-9)
        touched = {e // 64 for e, _, _ in cycles}
        assert set(colony.changed[: colony.changed_count[0]].tolist()) <= touched


def test_a_patch_all_of_whose_levels_are_at_a_bound_is_not_changed_any_more() -> None:
    colony = some_colony(tau0=1.0)
    pheromone.deposit(colony, FAR, 1.0)
    assert colony.changed_count[0] == 1
    for _ in range(2):
        pheromone.clamp(colony, 2.0, 2.0)
    assert colony.changed_count[0] == 0
    assert (colony.stored == colony.background[0]).all()


@pytest.mark.parametrize("level", [1e-3, 7.0, 1e200], ids=str)
def test_one_value_is_spread_over_what_was_changed_and_over_everything(level: float) -> None:
    colony = some_colony(alpha=1.0)
    for value in (1.0, 1.0, 0.25):
        pheromone.deposit(colony, FAR, level)
        refresh(colony)
        spread(colony, value)
        assert (colony.stored == value).all()
        assert (colony.weight == value * colony.desirability).all()
        assert colony.changed_count[0] == 0
        assert colony.background[0] == value


def test_without_a_background_every_edge_is_looked_at() -> None:
    colony = some_colony(alpha=1.0)
    colony.stored[:] = np.random.default_rng(1).uniform(0.0, 3.0, colony.stored.size)
    without(colony)
    assert colony.background[0] == NONE
    np.testing.assert_allclose(colony.weight, colony.stored * colony.desirability)
    plain = levels(colony).clip(1.0, 2.0)
    pheromone.clamp(colony, 1.0, 2.0)
    np.testing.assert_allclose(levels(colony), plain)
