"""Pheromone levels and weights are those of a plain model, whatever is done in whatever order."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from samples import colony_on, problem_on, trails_of

from acoexp import Grid
from acoexp.colony import pheromone
from acoexp.colony.background import reset
from acoexp.colony.changes import note_change, refresh
from acoexp.colony.problem import Problem
from acoexp.colony.state import Colony
from acoexp.trial.workspace import direction_offsets

GRID = Grid([[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]])
WALKS = [[0, 0, 7, 6], [0, 0, 0, 6, 6], [6, 6, 0, 0, 0], [0, 7, 7], [0, 0, 6, 0, 6]]
"""Ways from the upper left to the lower right corner; some share edges."""


def edges_of(problem: Problem) -> list[int]:
    """Return all edges whose move is allowed."""
    return np.flatnonzero(problem.per_edge(problem.allowed_edges(), border=False)).tolist()


PROBLEM = problem_on(GRID)
EDGES = edges_of(PROBLEM)

amounts = st.floats(1e-3, 1e3) | st.sampled_from([1e-100, 1e100])
edges = st.sampled_from(EDGES)
rates = st.sampled_from([0.0, 0.3, 0.5, 1 - 1e-6, 1.0])
operations = st.one_of(
    st.tuples(st.just("deposit"), edges, amounts),
    st.tuples(st.just("set_level"), edges, amounts),
    st.tuples(st.just("multiply"), edges, st.floats(1.0, 2.0)),
    st.tuples(st.just("multiply_one"), edges, st.floats(1.0, 2.0)),
    st.tuples(st.just("lay"), st.sampled_from(WALKS), amounts),
    st.tuples(st.just("evaporate"), rates),
    st.tuples(st.just("clamp"), st.floats(1e-3, 0.5), st.floats(0.5, 10.0)),
    st.tuples(st.just("refresh")),
)


def edges_along(colony: Colony, walk: list[int]) -> list[int]:
    cells = colony.start + np.cumsum([0, *colony.offsets[walk[:-1]]])
    return [int(cell) * 8 + move for cell, move in zip(cells, walk, strict=True)]


class OnCells(dict[int, float]):
    """A model in which all edges into one cell have one level."""

    def __setitem__(self, edge: int, level: float) -> None:
        for other in self:
            if target_of(other) == target_of(edge):
                super().__setitem__(other, level)


def target_of(edge: int) -> int:
    return edge // 8 + int(direction_offsets(PROBLEM.width)[edge % 8])


def powers(direction: int, factor: float, alpha: float) -> NDArray[np.float64]:
    """Return the factor's power in this direction's row and column, and 1 elsewhere."""
    table = np.ones((9, 8))
    table[direction, direction] = np.power(factor, alpha)
    return table


def act(colony: Colony, model: dict[int, float], name: str, *arguments: Any) -> None:
    """Do the same to a colony and to the model: a level for each edge."""
    match name, arguments:
        case "deposit", (edge, amount):
            pheromone.deposit(colony, edge, amount)
            model[edge] += amount
        case "set_level", (edge, amount):
            pheromone.set_level(colony, edge, amount)
            model[edge] = amount
        case "multiply", (edge, factor):
            pheromone.multiply(colony, edge, factor, np.power(factor, colony.alpha))
            model[edge] *= factor
        case "multiply_one", (edge, factor):
            note_change(colony, edge)  # as the ant's walk does
            pheromone.multiply_one(colony, edge // 8, edge % 8, factor, powers(edge % 8, factor, colony.alpha))
            model[edge] *= factor
        case "lay", (walk, amount):
            pheromone.lay(colony, trails_of(colony, None, walk), 1, amount)
            for edge in edges_along(colony, walk):
                model[edge] += amount
        case "evaporate", (rate,):
            pheromone.evaporate(colony, rate)
            model.update({edge: level * (1 - rate) for edge, level in model.items()})
        case "clamp", (lowest, highest):
            pheromone.clamp(colony, lowest, highest)
            model.update({edge: min(max(level, lowest), highest) for edge, level in model.items()})
        case "refresh", ():
            refresh(colony)


def assert_levels(colony: Colony, model: dict[int, float]) -> None:
    tiny = 1e-290 * max(1.0, *model.values())
    for edge, expected in model.items():
        assert math.isclose(pheromone.level(colony, edge), expected, rel_tol=1e-9, abs_tol=tiny)


def assert_weights(colony: Colony, model: dict[int, float]) -> None:
    """Compare each weight with tau^alpha * eta^beta, up to a common factor."""
    for edge, level in model.items():
        expected = (level / colony.scale[0]) ** colony.alpha * colony.desirability[edge]
        assert math.isclose(colony.weight[edge], expected, rel_tol=1e-9, abs_tol=1e-290)


def some_colony(
    alpha: float, room: int | None = None, pheromone: str = "edges"
) -> tuple[Colony, dict[int, float]]:
    """Return a colony with room for so many edges whose weight may wait, and the model of it."""
    problem = problem_on(GRID, alpha=alpha, tau0=0.7, pheromone=pheromone)
    colony = colony_on(problem, np.random.default_rng(0).uniform(0.1, 1.0, (*GRID.shape, 8)))
    if room is not None:
        colony = colony._replace(stale=colony.stale[:room])
    levels = dict.fromkeys(EDGES, 0.7)
    return colony, OnCells(levels) if pheromone == "cells" else levels


@settings(deadline=None, max_examples=300)
@given(
    st.lists(operations, max_size=40),
    st.sampled_from([0.0, 0.5, 1.1, 2.0, 100.0]),
    st.sampled_from([None, 0, 1, 5]),
    st.sampled_from(["edges", "cells"]),
)
def test_any_sequence_of_operations_does_what_it_does_to_a_plain_model(
    steps: list[tuple[Any, ...]], alpha: float, room: int | None, lies_on: str
) -> None:
    colony, model = some_colony(alpha, room, lies_on)
    for step in steps:
        act(colony, model, *step)
        assert_levels(colony, model)
    refresh(colony)
    assert_weights(colony, model)
    assert colony.stale_count[0] == 0


def test_on_cells_all_edges_into_a_cell_have_its_level() -> None:
    colony, _ = some_colony(1.1, pheromone="cells")
    pheromone.deposit(colony, EDGES[3], 1.0)
    changed = {edge for edge in EDGES if pheromone.level(colony, edge) != 0.7}
    assert changed == {edge for edge in EDGES if target_of(edge) == target_of(EDGES[3])}
    assert len(changed) > 1


@pytest.mark.parametrize("lies_on", ["edges", "cells"])
@pytest.mark.parametrize("name", ["deposit", "set_level", "multiply"])
def test_a_single_change_shows_in_the_weight_at_once(name: str, lies_on: str) -> None:
    colony, model = some_colony(1.1, pheromone=lies_on)
    act(colony, model, name, EDGES[7], 1.5)
    assert_weights(colony, model)


def test_while_an_ant_lays_weights_wait_and_levels_do_not() -> None:
    colony, model = some_colony(1.1)
    act(colony, model, "lay", WALKS[0], 2.0)
    act(colony, model, "lay", WALKS[1], 3.0)
    assert_levels(colony, model)
    assert colony.stale_count[0] == len({*edges_along(colony, WALKS[0]), *edges_along(colony, WALKS[1])})


def test_where_too_many_edges_wait_the_others_are_weighed_at_once() -> None:
    colony, model = some_colony(1.1, room=2)
    act(colony, model, "lay", WALKS[1], 2.0)
    assert colony.stale_count[0] == 2
    assert (colony.weight < 0.0).sum() == 2
    refresh(colony)
    assert_weights(colony, model)


def test_evaporation_goes_on_for_ever_without_underflow_of_its_factor() -> None:
    colony, model = some_colony(1.1)
    for _ in range(1000):
        act(colony, model, "evaporate", 0.5)
        act(colony, model, "lay", WALKS[2], 1.0)
        refresh(colony)
        assert colony.scale[0] > 1e-150
    assert_levels(colony, model)
    assert_weights(colony, model)


def test_when_all_evaporates_nothing_is_left_and_new_pheromone_counts() -> None:
    colony, model = some_colony(1.1)
    act(colony, model, "evaporate", 1.0)
    assert all(pheromone.level(colony, edge) == 0.0 for edge in EDGES)
    act(colony, model, "deposit", EDGES[0], 2.0)
    assert_levels(colony, model)
    assert_weights(colony, model)


@settings(deadline=None, max_examples=200)
@given(st.lists(operations, max_size=20), st.sampled_from([0.0, 1.1]), st.sampled_from(["edges", "cells"]))
def test_reset_forgets_everything_to_the_last_bit(
    steps: list[tuple[Any, ...]], alpha: float, lies_on: str
) -> None:
    colony, model = some_colony(alpha, pheromone=lies_on)
    parts = colony.stored, colony.weight, colony.scale, colony.is_changed
    fresh = [array.copy() for array in parts]
    for step in steps:
        act(colony, model, *step)
    reset(colony, np.array([0.7]))
    for array, before in zip(parts, fresh, strict=True):
        assert (array == before).all()
    assert colony.stale_count[0] == colony.changed_count[0] == 0


def test_where_no_direction_is_named_nothing_is_multiplied() -> None:
    colony, _ = some_colony(1.1)
    before = colony.stored.copy(), colony.weight.copy()
    pheromone.multiply_one(colony, EDGES[0] // 8, 8, 2.0, powers(0, 2.0, 1.1))
    assert (colony.stored == before[0]).all()
    assert (colony.weight == before[1]).all()


def test_the_initial_pheromone_may_differ_from_edge_to_edge() -> None:
    colony, _ = some_colony(1.1)
    initial = np.random.default_rng(1).uniform(1.0, 2.0, colony.stored.size)
    reset(colony, initial)
    model = {edge: float(initial[edge]) for edge in EDGES}
    assert_levels(colony, model)
    assert_weights(colony, model)


@pytest.mark.parametrize("alpha", [0.0, 1.1, 100.0])
def test_pheromone_that_no_float_holds_still_evaporates_and_grows(alpha: float) -> None:
    colony, _ = some_colony(alpha)
    with np.errstate(over="ignore"):
        for _ in range(4000):
            pheromone.multiply(colony, EDGES[7], 1.5, 1.5**alpha)
        assert not any(np.isnan(pheromone.level(colony, edge)) for edge in EDGES)
    for rate in (0.5, 1.0):
        pheromone.evaporate(colony, rate)
        pheromone.lay(colony, trails_of(colony, WALKS[0]), 0, 1.0)
        pheromone.deposit(colony, EDGES[0], 1.0)
        refresh(colony)
        assert np.isfinite(colony.stored).all()
        assert np.isfinite(colony.weight).all()
    assert math.isclose(pheromone.level(colony, EDGES[0]), 2.0)


def test_a_weight_that_underflowed_comes_back_with_the_pheromone() -> None:
    colony, _ = some_colony(100.0)
    pheromone.set_level(colony, EDGES[3], 1e-4)
    assert colony.weight[EDGES[3]] == 0.0
    for _ in range(200):
        pheromone.multiply(colony, EDGES[3], 1.046, 1.046**100.0)
    level = colony.stored[EDGES[3]]
    assert math.isclose(colony.weight[EDGES[3]], level**100.0 * colony.desirability[EDGES[3]], rel_tol=1e-9)
    assert colony.weight[EDGES[3]] > 0.0


def test_a_very_large_amount_reaches_every_edge_of_a_path_alike() -> None:
    colony, _ = some_colony(1.1)
    reset(colony, np.array([1e-100]))
    for _ in range(400):
        pheromone.evaporate(colony, 0.5)
    pheromone.lay(colony, trails_of(colony, WALKS[0]), 0, 1e100)
    levels = [pheromone.level(colony, edge) for edge in edges_along(colony, WALKS[0])]
    assert all(math.isclose(level, 1e100) for level in levels)


def test_ants_that_are_lost_for_ever_still_know_the_heuristic() -> None:
    colony, _ = some_colony(1.1)
    before = colony.weight.copy()
    for _ in range(5000):
        pheromone.evaporate(colony, 0.5)
    assert (colony.weight == before).all()
    assert colony.weight.max() > 0.0
