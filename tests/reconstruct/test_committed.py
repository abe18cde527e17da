"""The maps that come with the package: each is what its file says, and fits as its file says."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from reference import STEPS, Cell, Pair, Path
from scipy.stats import fisher_exact

from acoexp import Grid, MapError
from acoexp.maps import ensemble
from acoexp.reconstruct.calibration import standard_aco
from acoexp.reconstruct.fit import Fit
from acoexp.reconstruct.layout import is_layout, is_map, paint
from acoexp.reconstruct.outcomes import Outcomes
from acoexp.reconstruct.published import CYCLES, ENVIRONMENTS, Environment
from acoexp.registry.load_map import as_grid

EACH = pytest.mark.parametrize("environment", ENVIRONMENTS.values(), ids=list(ENVIRONMENTS))
FRESH = 100_000
"""Seeds from here on were used neither by the search nor for the fits in the files."""


def maps_of(environment: Environment) -> list[Grid]:
    """Return an environment's built-in map and its ensemble."""
    return [as_grid(environment.name), *ensemble(environment.name)]


@EACH
def test_an_ensemble_has_twenty_maps_or_more_and_no_two_are_near_each_other(environment: Environment) -> None:
    maps = maps_of(environment)
    assert len(maps) > 20
    for a, b in combinations(maps, 2):
        assert (a.obstacles != b.obstacles).mean() > 0.05, f"{a.name} and {b.name}"


@EACH
def test_a_map_is_made_of_the_rectangles_in_its_file(environment: Environment) -> None:
    for grid in maps_of(environment):
        rectangles = np.array([[int(n) for n in r.split()] for r in grid.metadata["rectangles"].split(",")])
        assert is_layout(rectangles)
        assert (paint(rectangles) == grid.obstacles).all()
        assert is_map(grid.obstacles)


@EACH
def test_a_map_has_the_published_optimum_under_the_rule_that_it_declares(environment: Environment) -> None:
    for grid in maps_of(environment):
        assert grid.moves == grid.metadata["moves"]
        assert (grid.shape, grid.start, grid.goal) == ((20, 20), (0, 0), (19, 19))
        assert grid.optimum_pair == environment.optimum


@EACH
def test_a_map_has_a_path_of_every_published_length(environment: Environment) -> None:
    for grid in maps_of(environment):
        for pair in environment.local_optima:
            path = path_of(grid, pair)
            assert path is not None, f"{grid.name} has no path of {pair}"
            assert len(set(path)) == len(path)
            assert grid.measure(np.array(path)) == pair


@pytest.mark.slow_without_jit
@EACH
def test_fresh_trials_fit_as_the_file_says(environment: Environment) -> None:
    """No count differs from the file's by more than chance: Fisher's exact test, corrected for their number."""
    aco, p_values = standard_aco(CYCLES), []
    for number, grid in enumerate(maps_of(environment)):
        trials = 200 if number == 0 else 40
        results = aco.on(grid).trials(range(FRESH, FRESH + trials))
        fit = Fit.of(environment, Outcomes.of(result.curve_pairs for result in results))
        told = int(grid.metadata["trials"])
        for key, counts in (("l1", fit.l1), ("l2", fit.l2)):
            for length, count in counts_of(grid.metadata[key]).items():
                table = [[count, told - count], [counts[length], trials - counts[length]]]
                p_values.append(fisher_exact(table).pvalue)
    assert min(p_values) > 0.01 / len(p_values)


def test_another_name_is_refused() -> None:
    with pytest.raises(MapError, match=r"ensemble: expected one of: fig13, env1, env2; got 'fig14'"):
        ensemble("fig14")


def counts_of(text: str) -> dict[str, int]:
    """Read the counts in a map's metadata."""
    return {length: int(count) for length, count in (part.split() for part in text.split(","))}


def path_of(grid: Grid, pair: Pair) -> Path | None:
    """Return a path of exactly so many (straight, diagonal) moves that visits no cell twice, or None."""
    ways = walks_to_goal(grid, sum(pair))

    def extended(path: Path, diagonal: int) -> Path | None:
        left = sum(pair) - len(path) + 1
        if left == 0:
            return path
        row, col = path[-1]
        for direction, (down, right) in enumerate(STEPS):
            target: Cell = (row + down, col + right)
            after = diagonal - direction % 2
            if not grid.allowed[row, col] >> direction & 1 or after < 0 or target in path:
                continue
            if int(ways[left - 1][target]) >> after & 1:
                found = extended([*path, target], after)
                if found is not None:
                    return found
        return None

    return extended([grid.start], pair[1]) if int(ways[-1][grid.start]) >> pair[1] & 1 else None


def walks_to_goal(grid: Grid, moves: int) -> list[NDArray[Any]]:
    """Return int64[rows, cols] for 0, 1, ... moves left: bit d is set where some walk has d diagonals left."""
    rows, cols = grid.shape
    ways = [np.zeros(grid.shape, dtype=np.int64)]
    ways[0][grid.goal] = 1
    for _ in range(moves):
        wide, here = np.pad(ways[-1], 1), np.zeros(grid.shape, dtype=np.int64)
        for direction, (down, right) in enumerate(STEPS):
            there = wide[1 + down : 1 + down + rows, 1 + right : 1 + right + cols]
            here |= np.where(grid.allowed >> direction & 1, there << direction % 2, 0)
        ways.append(here)
    return ways
