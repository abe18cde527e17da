"""The heuristic coarse: the way from room to room, and in a straight line to the next."""

from __future__ import annotations

import heapq
import math
from collections import defaultdict
from typing import Any

import numpy as np
import pytest
from reference_paths import moves_of
from samples import drawn, problem_on, random_grid

from acoexp import Grid
from acoexp.strategies.heuristic.coarse import Coarse, coarse_distance

Cell = tuple[int, int]


def rooms_of(grid: Grid, size: int) -> tuple[dict[Cell, int], dict[int, set[int]]]:
    """Return the room of each free cell, and to which others doors lead, by walking about in each block."""
    moves = moves_of(grid)

    def block(cell: Cell) -> Cell:
        return cell[0] // size, cell[1] // size

    room: dict[Cell, int] = {}
    for first in sorted(moves):
        waiting, number = [first], len(room)
        while waiting:
            cell = waiting.pop()
            if cell not in room:
                room[cell] = number
                waiting += [target for target in moves[cell].values() if block(target) == block(cell)]
    doors: dict[int, set[int]] = defaultdict(set)
    for cell, ways in moves.items():
        doors[room[cell]] |= {room[target] for target in ways.values()} - {room[cell]}
    return room, doors


def expected(grid: Grid, size: int) -> dict[Cell, list[float]]:
    """Return the distance of each free cell, by Dijkstra's algorithm; several where ways are equally long."""
    room, doors = rooms_of(grid, size)
    cells = defaultdict(list)
    for cell, number in room.items():
        cells[number].append(cell)
    centre: dict[int, Any] = {number: tuple(np.mean(inside, axis=0)) for number, inside in cells.items()}
    left: dict[int, float] = {}
    waiting = [(0.0, room[grid.goal])]
    while waiting:
        length, number = heapq.heappop(waiting)
        if number not in left:
            left[number] = length
            for other in doors[number]:
                heapq.heappush(waiting, (length + math.dist(centre[other], centre[number]), other))

    def of(cell: Cell) -> list[float]:
        here = room[cell]
        if here == room[grid.goal]:
            return [math.dist(cell, grid.goal)]
        following = [
            other
            for other in doors[here]
            if here in left and math.isclose(left[here], left[other] + math.dist(centre[here], centre[other]))
        ]
        return [math.dist(cell, centre[other]) + left[other] for other in following] or [math.inf]

    return {cell: of(cell) for cell in room}


@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
@pytest.mark.parametrize("size", [2, 3, 5, 8])
def test_a_cell_is_as_far_as_by_the_centres_of_rooms(size: int, moves: str) -> None:
    for seed in range(3):
        grid = random_grid(seed, 17, 22, moves)
        found = coarse_distance(grid, size)
        for cell, distances in expected(grid, size).items():
            assert any(found[cell] == pytest.approx(distance, rel=1e-9) for distance in distances), cell


def test_in_one_block_it_is_the_straight_line() -> None:
    grid = random_grid(3, 6, 9, "free")
    found = coarse_distance(grid, 1024)
    room, _ = rooms_of(grid, 1024)
    for cell, number in room.items():
        if number == room[grid.goal]:
            assert found[cell] == pytest.approx(math.dist(cell, grid.goal))


def test_a_dead_end_of_several_rooms_is_seen_where_the_straight_line_leads_into_it() -> None:
    grid, _ = drawn("a....... .######. ......#. ......#b ######.. ........", "no_cut")
    found = coarse_distance(grid, 2)
    assert found[0, 3] < found[2, 4]  # although that is nearer as the crow flies


def test_eta_is_the_descent_of_that_and_one_where_no_way_leads() -> None:
    grid, _ = drawn("a.#. ..## ...b", "no_cut")
    eta = Coarse(strength=1.5, size=2).eta(problem_on(grid))
    found = coarse_distance(grid, 2)
    assert eta[0, 0, 0] == pytest.approx(math.exp(1.5 * (found[0, 0] - found[0, 1])))
    assert np.isfinite(eta).all()
