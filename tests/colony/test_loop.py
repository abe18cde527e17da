"""The compiled colony does, trial by trial, what the plain one in ``reference.py`` does."""

from __future__ import annotations

from typing import Any

import numba
import pytest
import reference
from reference import Colony
from samples import ALGOS, as_cells, random_grid, settings_of

import acoexp
from acoexp import Grid
from acoexp.registry.load_map import as_grid
from acoexp.strategies.diffusion.source import SOURCES

JIT = not numba.config.DISABLE_JIT
SEEDS = range(5) if JIT else range(2)
CYCLES = 25 if JIT else 6

OTHER_CONSTANTS = {
    "sharp": {"alpha": 2.0, "beta": 5.0, "rho": 0.2, "gamma": 0.3, "q": 30.0, "tau0": 8.0, "at_goal": 2.0},
    "forgetful": {"alpha": 0.7, "beta": 1.0, "rho": 0.99, "gamma": 0.2, "ants": 3},
    "blind": {"alpha": 0.0, "beta": 0.0, "rho": 0.0, "gamma": 1.0, "ants": 25},
    "pushed": {"repulsion": 300.0, "reach": 2.5, "attraction": 0.1, "guidance": 2.0, "gamma": 0.5},
}

READINGS: list[tuple[str, dict[str, Any]]] = [
    ("pd", {"pheromone": "cells", "order": "lock_step", "source": "walked_edge"}),
    ("pd", {"obstacles": "nearest"}),
    ("pdg", {"dead_end": "step_back"}),
    ("pdg", {"dead_end": "step_back", "max_steps": 45}),
    ("pdg", {"order": "two_ended", "dead_end": "step_back"}),
    *(("aco", {"order": order, "patience": 3, "rho": 0.1}) for order in ("in_turn", "lock_step", "two_ended")),
]
"""Other decisions where the paper leaves one open: those that make kernels the most different."""

MORE_READINGS: list[tuple[str, dict[str, Any]]] = [
    ("pdg", {"pheromone": "cells"}),
    *((algo, {"source": source}) for algo in ("pd", "pf") for source in SOURCES),
    *((algo, {"pheromone": "cells", "source": source}) for algo in ("pd", "pf") for source in SOURCES),
    *((algo, {"pheromone": lies, "order": "lock_step"}) for algo in ALGOS for lies in ("edges", "cells")),
    ("pf", {"obstacles": "nearest"}),
    ("pd", {"dead_end": "step_back", "order": "lock_step", "pheromone": "cells"}),
    ("pd", {"order": "two_ended", "max_steps": 17}),
]
"""Where each would have to be compiled, that would take minutes."""


def assert_same_trial(grid: Grid, colony: Colony, seed: int) -> None:
    """Compare everything that a trial leaves behind.

    The sum of all ants' steps and each cycle's lost ants make it all but impossible that one ant of one
    cycle went another way and nothing shows.
    """
    result = acoexp.solve(grid, colony.algo, seed, **settings_of(colony))
    expected = reference.run(grid, colony, seed)
    assert as_cells(result.path) == expected.path
    assert as_cells(result.raw_path) == expected.raw_path
    assert result.curve_pairs.tolist() == [list(pair or (-1, -1)) for pair in expected.curve]
    assert result.lost_ants.tolist() == expected.lost
    assert result.ant_steps == expected.steps


@pytest.mark.parametrize("algo", ALGOS)
@pytest.mark.parametrize("name", ["fig13", "env1", "env2"])
def test_on_the_papers_maps_every_trial_is_the_references(name: str, algo: str) -> None:
    for seed in SEEDS:
        assert_same_trial(as_grid(name), Colony(algo, iterations=CYCLES), seed)


@pytest.mark.parametrize("algo", ALGOS)
@pytest.mark.parametrize("constants", OTHER_CONSTANTS)
@pytest.mark.parametrize("moves", ["free", "no_squeeze", "no_cut", "four"])
def test_on_other_maps_and_with_other_constants_too(moves: str, constants: str, algo: str) -> None:
    colony = Colony(algo, **{"iterations": CYCLES, **OTHER_CONSTANTS[constants]})
    for seed, (rows, cols) in zip(SEEDS, [(9, 30), (23, 14)], strict=False):
        assert_same_trial(random_grid(seed, rows, cols, moves), colony, seed)


@pytest.mark.parametrize(("algo", "reading"), READINGS + ([] if JIT else MORE_READINGS), ids=str)
def test_under_the_other_readings_of_the_paper_too(algo: str, reading: dict[str, Any]) -> None:
    """With the paper's constants, and with such that make the differences large."""
    assert_same_trial(as_grid("env2"), Colony(algo, iterations=CYCLES, **reading), 0)
    for seed, moves in zip(SEEDS, ["free", "no_squeeze", "no_cut"], strict=False):
        constants = OTHER_CONSTANTS[["sharp", "forgetful", "pushed"][seed]]
        colony = Colony(algo, **{"iterations": CYCLES, **constants, **reading})
        assert_same_trial(random_grid(seed, 9, 20, moves), colony, seed)
