"""What several tests need: random and drawn maps, colonies for the reference and for ``acoexp``."""

from __future__ import annotations

import random
from heapq import heappop, heappush
from itertools import pairwise
from types import SimpleNamespace
from typing import Any

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray
from reference import Cell, Colony, Pair, Path, length_of, moves_of

from acoexp import Grid, Result
from acoexp.colony.background import reset
from acoexp.colony.problem import Problem
from acoexp.colony.random import seed_stream
from acoexp.colony.scalars import ColonySettings
from acoexp.colony.state import Colony as State
from acoexp.colony.state import Own, Room, Trails
from acoexp.colony.trails import measure
from acoexp.grid import MOVE_RULES
from acoexp.grid.field import FieldSettings
from acoexp.trial.workspace import new_colony, new_crowd, new_given_up, new_trails

ALGOS = ("aco", "pd", "pdg", "pf")


def random_grid(seed: int, rows: int, cols: int, moves: str, density: float = 0.25) -> Grid:
    """Return a map with obstacles, start and goal at random places, and a way between the two."""
    draw = random.Random(seed)
    while True:
        obstacles = [[draw.random() < density for _ in range(cols)] for _ in range(rows)]
        allowed = moves_of(SimpleNamespace(obstacles=obstacles, moves=moves))
        start = draw.choice([*sorted(allowed), None])
        goals = sorted(reach_of(allowed, start) - {start}) if start else []
        if start and goals:
            return Grid(obstacles, start=start, goal=draw.choice(goals), moves=moves)
        density *= 0.9


def reach_of(allowed: dict[Cell, dict[int, Cell]], start: Cell) -> set[Cell]:
    """Return all cells that some way leads to."""
    reached, frontier = {start}, [start]
    while frontier:
        new = set(allowed[frontier.pop()].values()) - reached
        reached |= new
        frontier += new
    return reached


def grids(largest: int = 40) -> st.SearchStrategy[Grid]:
    """Maps from 2 x 2 cells on, under any rule, from any start to any goal that a way leads to."""
    side = st.integers(2, largest)
    density = st.floats(0.0, 0.6)
    return st.builds(random_grid, st.integers(0, 2**32), side, side, st.sampled_from(MOVE_RULES), density)


def settings_of(colony: Colony) -> dict[str, Any]:
    """Return what ``acoexp.solve`` must be told for the same colony."""
    scalars = (
        "ants",
        "iterations",
        "alpha",
        "beta",
        "rho",
        "q",
        "tau0",
        "pheromone",
        "order",
        "dead_end",
        "max_steps",
        "patience",
    )
    guided = {"guidance": colony.guidance} if colony.algo == "pf" else {}
    return {
        **{key: getattr(colony, key) for key in scalars},
        "field": {key: getattr(colony, key) for key in ("attraction", "repulsion", "reach", "obstacles")},
        "heuristic": {"at_goal": colony.at_goal, **guided},
        "diffusion": {"gamma": colony.gamma, "source": colony.source} if colony.algo != "aco" else {},
    }


def as_cells(path: NDArray[Any] | None) -> Path | None:
    """Return a result's path as the reference has it."""
    return None if path is None else [(row, col) for row, col in path.tolist()]


def everything(result: Result) -> tuple[Any, ...]:
    """Return all that a trial leaves behind, to be compared."""
    lists = result.curve_pairs.tolist(), result.lost_ants.tolist()
    return as_cells(result.path), as_cells(result.raw_path), *lists, result.ant_steps


def is_way(grid: Any, path: Path) -> bool:
    """Whether a path leads from start to goal by allowed moves alone, with no cell twice."""
    moves = moves_of(grid)
    steps = all(b in moves[a].values() for a, b in pairwise(path))
    return steps and (path[0], path[-1]) == (grid.start, grid.goal) and len(set(path)) == len(path)


def optimum_of(grid: Any) -> Pair:
    """The shortest way's moves, by Dijkstra's algorithm."""
    moves, settled = moves_of(grid), set()
    heap = [(0.0, (0, 0), grid.start)]
    while heap:
        _, (straight, diagonal), cell = heappop(heap)
        if cell == grid.goal:
            return straight, diagonal
        if cell not in settled:
            settled.add(cell)
            for d, target in moves[cell].items():
                pair = (straight + 1 - d % 2, diagonal + d % 2)
                heappush(heap, (length_of(pair), pair, target))
    raise ValueError("no way")


def drawn(drawing: str, moves: str = "no_squeeze") -> tuple[Grid, dict[str, Cell]]:
    """Return the map of a drawing: ``#`` is an obstacle, letters are free cells with a name.

    The first letter of the alphabet that is there is the start, the last is the goal.
    """
    rows = drawing.split()
    named = {mark: (r, c) for r, row in enumerate(rows) for c, mark in enumerate(row) if mark.isalpha()}
    obstacles = [[mark == "#" for mark in row] for row in rows]
    return Grid(obstacles, start=named[min(named)], goal=named[max(named)], moves=moves), named


def problem_on(grid: Grid, field: dict[str, Any] | None = None, **scalars: Any) -> Problem:
    """Return what a part is prepared with."""
    return Problem(grid, ColonySettings(**scalars), FieldSettings(**field or {}))


def number_of(problem: Problem, cell: Cell) -> np.int64:
    """Return a cell's number as kernels have it."""
    return np.int64(problem.cell(cell))


def colony_on(problem: Problem, eta: float | NDArray[np.float64] = 1.0) -> State:
    """Return a colony before the first ant: the pheromone is tau0 everywhere, the seed is 0."""
    desirability = np.where(problem.allowed_edges(), np.asarray(eta) ** problem.settings.beta, 0.0)
    colony = new_colony(problem, problem.per_edge(desirability, border=0.0), np.zeros(1, dtype=np.uint8))
    reset(colony, np.array([problem.settings.tau0]))
    with np.errstate(over="ignore"):
        seed_stream(colony.random, np.uint64(0))
    return colony


def room_of(colony: State, **own: Any) -> Room:
    """Return what the loop works on, in either order, with no post-optimiser; own state by its part's group."""
    ants, cells = colony.ants, colony.allowed.size
    raw = new_trails(ants, cells)
    return Room(
        colony=colony,
        crowd=new_crowd(ants, cells),
        facing=None,
        given_up=new_given_up(ants, cells),
        made=np.zeros(ants, dtype=np.int64),
        own=Own(**{group: own.get(group, ()) for group in Own._fields}),
        initial=np.array([colony.tau0]),
        raw=raw,
        final=raw,
        best=new_trails(2, cells),
        cells=np.empty(1, dtype=np.int32),
    )


def trails_of(colony: State, *walks: list[int] | None) -> Trails:
    """Return the ways of some ants, each given by its directions; None is a lost ant."""
    trails = new_trails(len(walks), colony.allowed.size)
    for ant, walk in enumerate(walks):
        trails.moves[ant, : len(walk or [])] = walk or []
        measure(trails, ant, len(walk or []), sum(move % 2 == 0 for move in walk or []))
        trails.length[ant] = np.inf if walk is None else trails.length[ant]
    return trails


@st.composite
def walks(draw: st.DrawFn) -> tuple[Grid, Path]:
    """A map and a way that an ant with no sense of direction found; the shortest one if it never arrived."""
    grid, seed = draw(grids(9)), random.Random(draw(st.integers(0, 2**32)))
    moves = moves_of(grid)
    for _ in range(30):
        path, ways = [grid.start], True
        while path[-1] != grid.goal and ways:
            ways = sorted(set(moves[path[-1]].values()) - set(path))
            path += [seed.choice(ways)] if ways else []
        if path[-1] == grid.goal:
            return grid, path
    return grid, [(row, col) for row, col in grid.shortest_path.tolist()]
