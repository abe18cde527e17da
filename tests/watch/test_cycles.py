"""What a recording tells of each cycle."""

from __future__ import annotations

import numpy as np
import pytest
from samples import is_way, random_grid

from acoexp import Recording, SettingsError, record
from acoexp.grid.moves import follow

pytestmark = pytest.mark.slow_without_jit


def test_ways_lead_from_the_start_and_those_of_lost_ants_not_to_the_goal(recording: Recording) -> None:
    grid, lost = recording.grid, 0
    for cycle in range(1, recording.cycles + 1):
        ways = recording.ways(cycle)
        assert len(ways) == 10
        for way in ways:
            cells = [(row, col) for row, col in follow(grid.start, way.moves).tolist()]
            if way.lost:
                assert cells[-1] != grid.goal
                assert way.polished is None
            else:
                assert is_way(grid, cells)
                assert way.polished is not None
                assert is_way(grid, [(row, col) for row, col in follow(grid.start, way.polished).tolist()])
                assert way.length == pytest.approx(sum((1, 2**0.5)[move % 2] for move in way.polished.tolist()))
        assert sum(way.lost for way in ways) == recording.result.lost_ants[cycle - 1]
        lost += sum(way.lost for way in ways)
    assert lost > 0


def test_the_best_of_each_cycle_and_so_far_are_the_results(recording: Recording) -> None:
    result = recording.result
    for row, ant in enumerate(recording.winners.tolist()):
        assert recording.lengths[row, ant] == result.curve[row]
    assert [best.cycle for best in recording.bests][-1] == result.x1
    assert recording.bests[-1].moves.tolist() == result.moves.tolist()  # type: ignore[union-attr]
    lengths = [best.length for best in recording.bests]
    assert lengths == sorted(set(lengths), reverse=True)


def test_where_all_ants_are_lost_there_is_no_best() -> None:
    grid = random_grid(1, 30, 30, "no_cut")
    lost = record(grid, "aco", seed=0, iterations=3, max_steps=1)
    assert lost.winners.tolist() == [-1, -1, -1]
    assert lost.bests == []


def test_pheromone_is_there_before_the_first_cycle_and_after_each(recording: Recording) -> None:
    assert recording.pheromone.shape == (13, 20, 20)
    assert recording.pheromone.dtype == np.float32
    assert not recording.pheromone[:, recording.grid.obstacles].any()


@pytest.mark.parametrize("cycle", [0, 13, -1, 1.0, True, "1", None])
def test_a_cycle_that_there_is_not_is_refused(recording: Recording, cycle: object) -> None:
    for ask in (recording.ways, recording.pheromone_on_edges):
        with pytest.raises(SettingsError, match=r"cycle: expected a whole number from 1 to 12; got"):
            ask(cycle)  # type: ignore[operator]
