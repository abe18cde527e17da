"""The exact optimum: what every result is measured against."""

from __future__ import annotations

from heapq import heappop, heappush
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from numpy.typing import NDArray
from reference import Pair, moves_of
from samples import grids, random_grid
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from acoexp import Grid
from acoexp.grid import DIRECTIONS, MOVE_RULES, SQRT2, optimum
from acoexp.maps.builtin import Env1, Env2, Fig13


class Length:
    """A length s + d sqrt 2, compared in whole numbers alone: a + b sqrt 2 has the sign of a |a| + 2 b |b|."""

    def __init__(self, straight: int, diagonal: int) -> None:
        self.pair = (straight, diagonal)

    def __lt__(self, other: Length) -> bool:
        a, b = (mine - theirs for mine, theirs in zip(self.pair, other.pair, strict=True))
        return a * abs(a) + 2 * b * abs(b) < 0


def exact_optimum(grid: Grid) -> Pair:
    """Return the shortest path's moves, by Dijkstra's algorithm on exact lengths."""
    moves, settled = moves_of(grid), set()
    heap = [(Length(0, 0), grid.start)]
    while heap:
        length, cell = heappop(heap)
        if cell == grid.goal:
            return length.pair
        if cell not in settled:
            settled.add(cell)
            straight, diagonal = length.pair
            for direction, target in moves[cell].items():
                odd = direction % 2
                heappush(heap, (Length(straight + 1 - odd, diagonal + odd), target))
    raise AssertionError("a grid has a way from start to goal")


def by_scipy(grid: Grid) -> NDArray[np.float64]:
    """Return each cell's distance to the goal, as scipy's Dijkstra finds it on a graph of all allowed moves."""
    row, col, direction = np.nonzero(np.unpackbits(grid.allowed[..., None], axis=-1, bitorder="little"))
    steps = np.array(DIRECTIONS)[direction]
    ends = (
        np.ravel_multi_index(cells, grid.shape) for cells in ((row, col), (row + steps[:, 0], col + steps[:, 1]))
    )
    graph = csr_array((np.where(direction % 2, SQRT2, 1.0), tuple(ends)), shape=(grid.allowed.size,) * 2)
    found: NDArray[np.float64] = dijkstra(graph, indices=np.ravel_multi_index(grid.goal, grid.shape))
    return found.reshape(grid.shape)


def test_exact_lengths_compare_where_floats_are_close() -> None:
    assert Length(1607521, 0) < Length(0, 1136689)
    assert Length(0, 470832) < Length(665857, 0)
    assert not Length(3, 2) < Length(3, 2)


@given(grids(15))
@settings(max_examples=150, deadline=None)
def test_the_optimum_is_that_of_an_exact_solver(grid: Grid) -> None:
    assert grid.optimum_pair == exact_optimum(grid)


@given(grids(15))
@settings(deadline=None)
def test_the_shortest_path_is_a_path_as_long_as_the_optimum(grid: Grid) -> None:
    path = [tuple(cell) for cell in grid.shortest_path.tolist()]
    moves = moves_of(grid)
    assert (path[0], path[-1]) == (grid.start, grid.goal)
    assert all(after in moves[before].values() for before, after in pairwise(path))
    assert grid.measure(grid.shortest_path) == grid.optimum_pair


@pytest.fixture(params=["in plain Python", "compiled"])
def size(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Maps of any size are taken for small ones, then for large ones."""
    monkeypatch.setattr(optimum, "COMPILED_FROM", 0 if request.param == "compiled" else 2**62)


@pytest.mark.usefixtures("size")
@pytest.mark.parametrize("rule", MOVE_RULES)
@pytest.mark.parametrize("density", [0.0, 0.1, 0.3, 0.5])
def test_distances_are_bit_for_bit_those_of_another_solver(rule: str, density: float) -> None:
    """A float is the same sum in any order of search: the least over all neighbours of theirs plus the move."""
    for seed in range(12):
        rows, cols = np.random.default_rng(seed).integers(2, 60, 2).tolist()
        grid = random_grid(seed, rows, cols, rule, density=density)
        assert np.array_equal(optimum.distances(grid.allowed, grid.goal), by_scipy(grid))


@pytest.mark.usefixtures("size")
@pytest.mark.parametrize("rule", MOVE_RULES)
def test_a_shortest_path_is_as_long_as_the_distance_of_its_start(rule: str) -> None:
    for seed in range(12):
        grid = random_grid(seed, 40, 23, rule, density=0.3)
        path = optimum.shortest_path(grid.allowed, grid.start, grid.goal)
        assert path is not None
        straight, diagonal = grid.measure(path)
        assert by_scipy(grid)[grid.start] == pytest.approx(straight + diagonal * SQRT2, rel=1e-14)


@pytest.mark.usefixtures("size")
def test_where_no_way_leads_there_is_no_path_and_no_distance() -> None:
    """The map has two rooms; in either the search ends at the wall, and at the map's own border."""
    allowed = Grid([[0, 0, 0, 0], [0, 0, 0, 0]], goal=(1, 1)).allowed & np.array(
        [255, 0b01111100, 0b11000111, 255]
    )
    far = optimum.distances(allowed.astype(np.uint8), (1, 1))
    assert np.isinf(far).tolist() == [[False, False, True, True]] * 2
    assert optimum.shortest_path(allowed.astype(np.uint8), (0, 3), (1, 1)) is None


@pytest.mark.usefixtures("size")
def test_a_maze_of_one_long_corridor_is_walked_to_its_end() -> None:
    obstacles = np.zeros((41, 41), dtype=bool)
    obstacles[1::4, :-1] = obstacles[3::4, 1:] = True
    assert Grid(obstacles, moves="no_cut").optimum_pair == (21 * 40 + 40, 0)


@pytest.mark.parametrize(
    ("source", "pair", "length"),
    [(Fig13, (12, 13), 30.3848), (Env1, (18, 10), 32.1421), (Env2, (28, 5), 35.0711)],
)
def test_the_built_in_maps_have_the_published_optima(source: type, pair: Pair, length: float) -> None:
    grid = source().load()
    assert grid.optimum_pair == exact_optimum(grid) == pair
    assert round(grid.optimum, 4) == length


def test_a_diagonal_counts_as_the_square_root_of_two() -> None:
    """Two corridors, of 15 diagonals (21.21) and of 20 straight moves and a diagonal (21.41); 1.5 misjudges."""
    obstacles = np.ones((16, 12), dtype=bool)
    obstacles[range(12), range(12)] = obstacles[range(12, 16), range(10, 6, -1)] = False
    obstacles[:, 0] = obstacles[15, :8] = False
    assert Grid(obstacles, goal=(15, 7), moves="free").optimum_pair == (0, 15)


@pytest.mark.parametrize("rule", MOVE_RULES)
def test_an_open_map_is_crossed_by_its_diagonal(rule: str) -> None:
    assert Grid(np.zeros((20, 20)), moves=rule).optimum_pair == ((38, 0) if rule == "four" else (0, 19))


@pytest.mark.parametrize("rule", MOVE_RULES)
def test_a_large_map_is_solved(rule: str) -> None:
    """512 x 512, a quarter of it rectangles; no shorter than the open map's diagonal, and valid move by move."""
    rng = np.random.default_rng(0)
    obstacles = np.zeros((512, 512), dtype=bool)
    while obstacles.mean() < 0.25:
        (row, col), (height, width) = rng.integers(0, 512, 2), rng.integers(4, 40, 2)
        obstacles[row : row + height, col : col + width] = True
    obstacles[:4, :] = obstacles[:, -4:] = False  # a way along the rim
    grid = Grid(obstacles, moves=rule)
    straight, diagonal = grid.optimum_pair
    assert straight + diagonal >= 511
    along_the_rim = 511 + 511 if rule == "four" else 508 + 508 + 4 * 2**0.5
    assert 511 * 2**0.5 < grid.optimum <= along_the_rim
