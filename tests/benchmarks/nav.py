"""How presets fare on real maps: gap to the exact optimum, share of trials that arrive, seconds.

    python tests/benchmarks/nav.py FOLDER                 # nav beside aco, pdg and acs
    python tests/benchmarks/nav.py FOLDER --ablation      # nav with each of its parts left out or replaced, once

FOLDER has maps of the MovingAI benchmarks, each with a scenario whose name begins like the map's: the way is that
of its longest row. Or maps of ROS: the way is the longest that two searches, one from the end of the other, find.
Prints a table in Markdown, a row a map: mean gap (and how many of the seeds arrived, where not all did), seconds.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

import acoexp
from acoexp.grid.moves import allowed_moves
from acoexp.grid.optimum import distances
from acoexp.maps.map_server import occupancy, parse_description
from acoexp.maps.pixels import read_pixels
from acoexp.registry.resolve import resolve
from acoexp.trial.solver import Solver

PRESETS: dict[str, dict[str, Any]] = {"nav": {}, "aco": {}, "pdg": {}, "acs": {}}
ABLATION: dict[str, dict[str, Any]] = {
    "nav": {},
    "no shortcut": {"post": "geometric"},
    "paths as walked": {"post": "none"},
    "straight line": {"heuristic": "progress"},
    "exact distance": {"heuristic": "geodesic"},
    "ants are lost": {"dead_end": "lost"},
    "every ant lays": {"update": "ant_cycle"},
    "with diffusion": {"diffusion": "gaussian"},
    "no learning": {"alpha": 0.0},
    "one cycle": {"iterations": 1},
}
"""Settings beside the preset's, by what is left out or put in its place."""


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


def cell(solver: Solver, seeds: Iterable[int]) -> str:
    """Return what a row of the table says of one configuration."""
    gaps, began = [], time.perf_counter()
    for seed in seeds:
        result = solver.solve(seed)
        if result.path is not None:
            gaps.append(100.0 * (result.length / result.optimum - 1.0))
    seconds, trials = time.perf_counter() - began, len(list(seeds))
    if not gaps:
        return f"0 of {trials} | {seconds / trials:.2f}"
    arrived = "" if len(gaps) == trials else f" ({len(gaps)} of {trials})"
    return f"{np.mean(gaps):.1f} %{arrived} | {seconds / trials:.2f}"


def main() -> None:
    """Run all and print the table."""
    parser = argparse.ArgumentParser(description="Presets on real maps: gap to the optimum, arrivals, seconds.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--ablation", action="store_true")
    parser.add_argument("--seeds", type=int, default=5)
    arguments = parser.parse_args()
    chosen = ABLATION if arguments.ablation else PRESETS
    files = sorted([*arguments.folder.glob("*.map"), *arguments.folder.glob("*.yaml")])
    if not files:
        parser.error(f"folder: expected one with maps, *.map or *.yaml; got {arguments.folder}")
    headings = "".join(f" {name} | s |" for name in chosen)
    print(f"| map | optimum |{headings}\n|---|---|{'---|---|' * len(chosen)}")
    for file in files:
        grid = far_pair(file) if file.suffix == ".map" else far_pair_of_robots(file)
        rows, cols = grid.shape
        texts = [
            cell(Solver(grid, resolve("nav" if arguments.ablation else name, settings)), range(arguments.seeds))
            for name, settings in chosen.items()
        ]
        print(f"| {file.stem}, {cols} x {rows} | {grid.optimum:.0f} | {' | '.join(texts)} |", flush=True)


if __name__ == "__main__":
    main()
