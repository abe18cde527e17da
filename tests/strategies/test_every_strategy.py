"""Every strategy that is registered, by whomever, does in the paper's colony what a part has to do."""

from __future__ import annotations

from typing import Any

import numba
import pytest
from reference import length_of, pair_of
from samples import as_cells, everything, is_way, optimum_of, random_grid

import acoexp
from acoexp.registry.entries import entries
from acoexp.registry.presets import find_preset
from acoexp.strategies.groups import STRATEGY_GROUPS

STRATEGIES = [(group, name) for group in STRATEGY_GROUPS for name in entries(group)]


@pytest.mark.parametrize("moves", ["no_cut", "four"])
@pytest.mark.parametrize(("group", "name"), STRATEGIES, ids=map("-".join, STRATEGIES))
def test_swapped_into_pdg_it_finds_ways_and_the_same_ones_however_it_is_run(
    group: str, name: str, moves: str
) -> None:
    grid, seeds = random_grid(5, 12, 15, moves), range(6)
    settings: dict[str, Any] = {group: name, "ants": 4, "iterations": 12}
    single = [acoexp.solve(grid, "pdg", seed, **settings) for seed in seeds]
    for result in single:
        path = as_cells(result.path)
        assert path is not None
        assert is_way(grid, path)
        assert length_of(optimum_of(grid)) <= length_of(pair_of(path))
        assert result.algo == ("pdg" if find_preset("pdg").parts[group] == name else "custom")
    for threads in (1, 3):
        batch = acoexp.solve_many(grid, "pdg", seeds, threads=threads, **settings)
        assert list(map(everything, batch)) == list(map(everything, single))


VARIANTS = [("mmas", "turning"), *([("acs", "acs")] if numba.config.DISABLE_JIT else [])]
"""Without the JIT both: each takes half a minute to be compiled."""


@pytest.mark.parametrize(("algo", "choice"), VARIANTS)
def test_published_variants_walk_in_lock_step_with_pheromone_on_cells(algo: str, choice: str) -> None:
    """No part knows of cells or of lock step; these change pheromone in all ways there are, and look at tabu."""
    grid, seeds = random_grid(5, 12, 15, "no_cut"), range(4)
    few: dict[str, Any] = {"ants": 4, "iterations": 12, "choice": choice}
    other: dict[str, Any] = {"pheromone": "cells", "order": "lock_step"}
    results = acoexp.solve_many(grid, algo, seeds, threads=2, **few, **other)
    for result in results:
        path = as_cells(result.path)
        assert path is not None
        assert is_way(grid, path)
    single = [acoexp.solve(grid, algo, seed, **few, **other) for seed in seeds]
    assert list(map(everything, results)) == list(map(everything, single))
