"""How presets fare on real maps: gap to the exact optimum, trials that arrive, time.

Maps are those of the MovingAI benchmarks, each with a scenario whose name begins like the map's: the way is that
of its longest row. Or maps of ROS: the way is the longest that two searches, one from the end of the other, find.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from rows import Given, Row
from timing import interleave, seconds

import acoexp
from acoexp.grid.moves import allowed_moves
from acoexp.grid.optimum import distances
from acoexp.maps.map_server import occupancy, parse_description
from acoexp.maps.pixels import read_pixels
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

PRESETS = ("nav", "aco", "pdg", "acs")
SEEDS = range(5)


def far_pair(file: Path) -> acoexp.Grid:
    """Return a map with the row of its scenario that is the longest."""
    scenario = min(file.parent.glob(f"{file.name.removesuffix('.map')}*.scen"))
    rows = [line.split() for line in scenario.read_text(encoding="utf-8").splitlines()[1:] if line.strip()]
    farthest = max(range(len(rows)), key=lambda row: float(rows[row][-1]))
    return acoexp.load_map("movingai", path=str(file), scenario=str(scenario), instance=farthest)


def far_pair_of_robots(file: Path) -> acoexp.Grid:
    """Return a map of ROS between cells that lie as far apart as two searches find."""
    description = parse_description(file.read_text(encoding="utf-8"), file.name)
    found = occupancy(read_pixels(file.parent / description.image, "image"), description)
    allowed = allowed_moves(found != 0, "no_cut")
    here = tuple(map(int, np.argwhere(allowed)[0]))
    ends = []
    for _ in range(3):  # the first is anywhere
        distance = distances(allowed, here)
        here = np.unravel_index(int(np.where(np.isfinite(distance), distance, -1.0).argmax()), distance.shape)
        ends.append([int(index) for index in here])
    return acoexp.load_map("ros", path=str(file), start=ends[-2], goal=ends[-1], unit="cell")


def solve(solver: Solver, gaps: list[float]) -> None:
    """Run all seeds; note the gaps of those that arrive, in percent."""
    gaps[:] = [
        100.0 * (result.length / result.optimum - 1.0)
        for result in map(solver.solve, SEEDS)
        if result.path is not None
    ]


def of_maps(given: Given, configurations: Mapping[str, tuple[str, dict[str, Any]]]) -> Iterator[Row | str]:
    """Yield two rows for each map and each (preset, settings): the mean gap, and time beside the first's."""
    if given.maps is None:
        yield "no --maps"
        return
    first = next(iter(configurations))
    for file in sorted([*given.maps.glob("*.map"), *given.maps.glob("*.yaml")]):
        grid = far_pair(file) if file.suffix == ".map" else far_pair_of_robots(file)
        gaps: dict[str, list[float]] = {name: [] for name in configurations}
        jobs = {}
        for name, (preset, settings) in configurations.items():
            solver = Solver(grid, resolve(preset, settings))
            jobs[name] = partial(seconds, partial(solve, solver, gaps[name]))
        timing = interleave(given.rounds or 1, jobs)
        for name, found in gaps.items():
            arrived = f"{len(found)} of {len(SEEDS)} arrived, optimum {grid.optimum:.0f}"
            if found:
                yield Row(name=f"{file.stem}, {name}, gap", value=float(np.mean(found)), unit="%", note=arrived)
            base, note = "" if name == first else first, "" if found else arrived
            yield timing.row(name, base, unit="s", name=f"{file.stem}, {name}, {len(SEEDS)} trials", note=note)


def rows(given: Given) -> Iterator[Row | str]:
    """Yield nav beside aco, pdg and acs."""
    yield from of_maps(given, {name: (name, {}) for name in PRESETS})
