"""The tape: ways and levels as they are at the end of a cycle."""

from __future__ import annotations

import numpy as np
from samples import colony_on, drawn, number_of, problem_on, trails_of

from acoexp.colony.pheromone import set_level
from acoexp.colony.tape import Reel, note_levels, note_ways


def new_reel(room: int, cycles: int, ants: int) -> Reel:
    return Reel(np.zeros(room, dtype=np.uint8), np.zeros((cycles, ants), dtype=np.int64), np.zeros((cycles, ants)))


def test_ways_stand_one_after_another() -> None:
    grid, _ = drawn("A.. ... ..B")
    colony, reel = colony_on(problem_on(grid)), new_reel(20, 2, 2)
    assert note_ways(trails_of(colony, [7, 7], [0, 0, 6, 6]), reel, 0, True)
    assert note_ways(trails_of(colony, [6, 6, 0, 0], [7, 7]), reel, 1, True)
    assert reel.moves[:12].tolist() == [7, 7, 0, 0, 6, 6, 6, 6, 0, 0, 7, 7]
    assert reel.ends.tolist() == [[2, 6], [10, 12]]
    assert reel.length.tolist() == [[2 * 2**0.5, 4.0], [4.0, 2 * 2**0.5]]


def test_of_a_lost_ant_there_is_what_it_walked_and_nothing_polished() -> None:
    grid, _ = drawn("A.. ... ..B")
    trails = trails_of(colony_on(problem_on(grid)), [0, 0])
    trails.length[0] = np.inf
    walked, polished = new_reel(20, 1, 1), new_reel(20, 1, 1)
    assert note_ways(trails, walked, 0, True)
    assert note_ways(trails, polished, 0, False)
    assert (walked.ends[0, 0], polished.ends[0, 0]) == (2, 0)
    assert (walked.length[0, 0], polished.length[0, 0]) == (np.inf, np.inf)


def test_without_room_nothing_is_written_past_the_end() -> None:
    grid, _ = drawn("A.. ... ..B")
    trails = trails_of(colony_on(problem_on(grid)), [7, 7], [0, 0, 6, 6])
    assert not note_ways(trails, new_reel(5, 1, 2), 0, True)
    assert note_ways(trails, new_reel(0, 0, 2), 0, True)  # there is no post-optimiser


def test_a_cell_has_the_highest_level_on_an_edge_into_it() -> None:
    grid, cells = drawn("A#. B.. ..C")
    problem = problem_on(grid, tau0=0.5)
    colony = colony_on(problem)
    into = number_of(problem, cells["B"])
    set_level(colony, number_of(problem, cells["A"]) * 8 + 6, 3.0)  # A is above B
    levels = np.zeros(colony.allowed.size, dtype=np.float32)
    note_levels(colony, levels)
    assert levels[into] == 3.0
    assert levels[number_of(problem, cells["A"])] == 0.5
    assert levels[number_of(problem, (0, 1))] == 0.0
    assert levels[0] == 0.0
