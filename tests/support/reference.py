"""The whole colony a second time, in plain Python: the specification that the compiled one is held to.

Nothing here comes from ``acoexp`` but a map's data. Cells are (row, column), row 0 on top; directions 0..7
are E, NE, N, NW, W, SW, S, SE, so even ones are straight and odd ones diagonal.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import accumulate, pairwise
from types import SimpleNamespace
from typing import Any

from reference_paths import (
    ROOT2,
    STEPS,
    Cell,
    Moves,
    Pair,
    Path,
    direction_of,
    length_of,
    moves_of,
    optimised,
    pair_of,
)

Vector = tuple[float, float]
"""As (right, up)."""
Edge = tuple[Cell, int]
"""A cell and a direction."""
Levels = dict[Edge, float]
"""Something on every edge."""

SHARE = [1 - (1, ROOT2)[d % 2] / (1.5 * ROOT2) for d in range(8)]
"""Of what diffuses, the part that a move of direction d gets (Eqs 7 and 8)."""


@dataclass(frozen=True)
class Colony:
    """An algorithm and its constants: everything about a trial but its map and its seed."""

    algo: str
    ants: int = 10
    iterations: int = 200
    alpha: float = 1.1
    beta: float = 12.0
    rho: float = 0.5
    q: float = 1.0
    tau0: float = 1.0
    gamma: float = 0.01
    at_goal: float = 100.0
    guidance: float = 0.1
    attraction: float = 1.0
    repulsion: float = 25.0
    reach: float = 4.0
    pheromone: str = "edges"
    order: str = "in_turn"
    dead_end: str = "lost"
    max_steps: int | None = None
    patience: int | None = None
    source: str = "force_edge"
    obstacles: str = "sum"


@dataclass
class Found:
    """What a trial found: the run's best path, as optimised and as walked, and what each cycle brought."""

    path: Path | None = None
    raw_path: Path | None = None
    curve: list[Pair | None] = field(default_factory=list)
    lost: list[int] = field(default_factory=list)
    steps: int = 0


class Random:
    """xoshiro256++, its four words drawn from the seed by SplitMix64."""

    def __init__(self, seed: int) -> None:
        self.words = []
        for _ in range(4):
            seed = (seed + 0x9E3779B97F4A7C15) % 2**64
            z = (seed ^ seed >> 30) * 0xBF58476D1CE4E5B9 % 2**64
            z = (z ^ z >> 27) * 0x94D049BB133111EB % 2**64
            self.words.append(z ^ z >> 31)

    def word(self) -> int:
        a, b, c, d = self.words
        self.words = [a ^ d ^ b, a ^ b ^ c, a ^ c ^ (b << 17) % 2**64, _rotated(b ^ d, 45)]
        return (_rotated((a + d) % 2**64, 23) + a) % 2**64

    def uniform(self) -> float:
        return (self.word() >> 11) * 2.0**-53


def _rotated(word: int, left: int) -> int:
    return (word << left | word >> 64 - left) % 2**64


class Pheromone:
    """A level for each edge, or for each cell: then an edge has the level of the cell that it leads to."""

    def __init__(self, moves: Moves, lies_on: str, level: float) -> None:
        edges = {(cell, d): target for cell, ways in moves.items() for d, target in ways.items()}
        self.place: dict[Edge, Any] = {e: {"edges": e, "cells": target}[lies_on] for e, target in edges.items()}
        self.levels = dict.fromkeys(self.place.values(), level)

    def __contains__(self, edge: Edge) -> bool:
        return edge in self.place

    def __getitem__(self, edge: Edge) -> float:
        return self.levels[self.place[edge]]

    def __setitem__(self, edge: Edge, level: float) -> None:
        self.levels[self.place[edge]] = level


def forces_of(grid: Any, colony: Colony) -> dict[Cell, Vector]:
    """The resultant force at each cell (Eqs 1-4), as (right, up)."""
    walls = [(r, c) for r, row in enumerate(grid.obstacles) for c, wall in enumerate(row) if wall]
    forces = {}
    for r, c in moves_of(grid):
        right = colony.attraction * (grid.goal[1] - c)
        up = colony.attraction * (r - grid.goal[0])
        gross = math.hypot(right, up)
        rhos = {wall: math.dist((r, c), wall) for wall in walls}
        nearest = [wall for wall in walls if math.isclose(rhos[wall], min(rhos.values()))]
        pushing, share = (walls, 1) if colony.obstacles == "sum" else (nearest, 1 / max(1, len(nearest)))
        for wall in pushing:
            if (rho := rhos[wall]) <= colony.reach:
                push = share * colony.repulsion * (1 / rho - 1 / colony.reach) / rho**2
                right += push * (c - wall[1]) / rho
                up += push * (wall[0] - r) / rho
                gross += push
        cancels = math.hypot(right, up) <= 1e-12 * gross  # what is left is rounding
        forces[r, c] = (0, 0) if cancels else (right, up)
    return forces


def desirability_of(grid: Any, colony: Colony, forces: dict[Cell, Vector]) -> Levels:
    """eta of each edge: how near to the goal it leads and, for ACO-PF, how well it follows the force."""
    eta = {}
    for cell, moves in moves_of(grid).items():
        right, up = forces[cell]
        for d, target in moves.items():
            eta[cell, d] = colony.at_goal if target == grid.goal else 1 / math.dist(target, grid.goal)
            if colony.algo == "pf" and (right, up) != (0, 0):
                along = (right * STEPS[d][1] - up * STEPS[d][0]) / math.hypot(*STEPS[d])
                eta[cell, d] *= math.exp(colony.guidance * along / math.hypot(right, up))
    return eta


def source_of(tau: Any, cell: Cell, came: int | None, along: int, source: str) -> float:
    """phi(i) at a cell, where an ant came in some direction, or began; ``along`` is the edge along the force."""
    leaving = [d for d in range(8) if (cell, d) in tau]
    around = {d: (cell[0] + STEPS[d][0], cell[1] + STEPS[d][1]) for d in range(8)}
    match source:
        case "walked_edge":
            return 0.0 if came is None else float(tau[around[(came + 4) % 8], came])
        case "sum_in":
            return float(sum(tau[around[d], (d + 4) % 8] for d in leaving))
        case "mean_out":
            return float(sum(tau[cell, d] for d in leaving) / len(leaving))
        case "max_out":
            return float(max(tau[cell, d] for d in leaving))
    return float(tau[cell, along])


def diffuse_gaussian(tau: Any, cell: Cell, came: int | None, force: Vector, colony: Colony) -> None:
    """One move gets more: the one in whose sector the force lies (Eqs 5-8), if it is allowed."""
    d = math.floor(math.atan2(force[1], force[0]) / (math.pi / 4) + 0.5) % 8
    if force != (0, 0) and (cell, d) in tau:
        tau[cell, d] += colony.gamma * SHARE[d] * source_of(tau, cell, came, d, colony.source)


def diffuse_luo_wu(tau: Any, cell: Cell, came: int | None, force: Vector, colony: Colony) -> None:
    """The moves on both sides of the force get more, the nearer one most; its pheromone is the source."""
    if force == (0, 0):
        return
    sectors = math.atan2(force[1], force[0]) / (math.pi / 4)
    low = math.floor(sectors)
    nearness = {low % 8: 1 - (sectors - low), (low + 1) % 8: sectors - low}
    allowed = [d for d in nearness if (cell, d) in tau]
    if allowed:
        nearest = max(allowed, key=lambda d: (nearness[d], d == (low + 1) % 8))
        phi = source_of(tau, cell, came, nearest, colony.source)
        for d in allowed:
            tau[cell, d] += colony.gamma * SHARE[d] * nearness[d] * phi


class End:
    """One end of the way: what ants see that set out there, and the pheromone that they follow."""

    def __init__(self, grid: Any, colony: Colony, start: Cell, goal: Cell) -> None:
        way = SimpleNamespace(obstacles=grid.obstacles, moves=grid.moves, start=start, goal=goal)
        self.start, self.goal = start, goal
        self.moves, self.forces = moves_of(way), forces_of(way, colony)
        eta = desirability_of(way, colony, self.forces)
        self.desire = {edge: level**colony.beta for edge, level in eta.items()}
        self.tau = Pheromone(self.moves, colony.pheromone, colony.tau0)

    def update(self, paths: list[Path], colony: Colony) -> None:
        for place in self.tau.levels:
            self.tau.levels[place] *= 1 - colony.rho
        for path in paths:
            for a, b in pairwise(path):
                self.tau[a, direction_of(a, b)] += colony.q / length_of(pair_of(path))


def run(grid: Any, colony: Colony, seed: int) -> Found:
    """Run one trial (Sect. 3.4)."""
    random, found, best, in_vain = Random(seed), Found(), math.inf, 0
    ends = [End(grid, colony, grid.start, grid.goal)]
    if colony.order == "two_ended":
        ends.append(End(grid, colony, grid.goal, grid.start))
    diffuse = {"pd": diffuse_gaussian, "pdg": diffuse_gaussian, "pf": diffuse_luo_wu}.get(colony.algo)

    def walk(end: End, path: Path) -> Iterator[None]:
        """Walk step by step; a path that does not end at the goal is that of a lost ant."""
        visited, made, tau = set(path), 0, end.tau
        while (cell := path[-1]) != end.goal and (colony.max_steps is None or made < colony.max_steps):
            made += 1  # or it ends here
            if diffuse:
                came = direction_of(path[-2], cell) if len(path) > 1 else None
                diffuse(tau, cell, came, end.forces[cell], colony)
            ways = [(d, target) for d, target in sorted(end.moves[cell].items()) if target not in visited]
            weights = [tau[cell, d] ** colony.alpha * end.desire[cell, d] for d, _ in ways]
            sums, drawn = list(accumulate(weights)), random.uniform()
            if not ways:
                if colony.dead_end == "lost" or len(path) == 1:
                    return
                path.pop()  # which stays visited
                found.steps += 1
                yield
                continue
            if sums[-1] > 0:
                target = next(t for (_, t), s in zip(ways, sums, strict=True) if s > drawn * sums[-1])
            else:
                target = ways[int(random.uniform() * len(ways))][1]
            path.append(target)
            visited.add(target)
            found.steps += 1
            yield

    def walk_all() -> list[Path]:
        walks: list[Path] = [[grid.start] for _ in range(colony.ants)]
        walkers = [walk(ends[0], path) for path in walks]
        if colony.order == "in_turn":
            for walker in walkers:
                deque(walker, maxlen=0)
        while walkers:
            walkers = [walker for walker in walkers if next(walker, "stands") != "stands"]
        return [path for path in walks if path[-1] == grid.goal]

    def meet() -> Path | None:
        """Let two ants walk, one from each end, a step each in turn, until one is where the other came by."""
        paths = [[end.start] for end in ends]
        walkers: list[Any] = [walk(end, path) for end, path in zip(ends, paths, strict=True)]
        while any(walkers):
            for side in (0, 1):
                if walkers[side] and next(walkers[side], "stands") == "stands":
                    walkers[side] = None
                here = paths[side][-1]
                if here in paths[1 - side]:
                    way, back = (path[: path.index(here) + 1] for path in paths)
                    return way + back[-2::-1]
        return None

    for _ in range(colony.iterations):
        if colony.order == "two_ended":
            arrived = [path for path in (meet() for _ in range(colony.ants)) if path is not None]
        else:
            arrived = walk_all()
        shortened = [optimised(path, ends[0].moves) if colony.algo == "pdg" else path for path in arrived]
        for end, step in zip(ends, (1, -1), strict=False):
            end.update([path[::step] for path in arrived], colony)
            if colony.algo == "pdg":
                end.update([path[::step] for path in shortened], colony)
        found.lost.append(colony.ants - len(arrived))
        found.curve.append(min(map(pair_of, shortened), key=length_of, default=None))
        in_vain += 1
        for raw, path in zip(arrived, shortened, strict=True):
            if length_of(pair_of(path)) < best:
                best, found.path = length_of(pair_of(path)), path
                found.raw_path, in_vain = raw if colony.algo == "pdg" else None, 0
        if in_vain == colony.patience:
            break
    return found
