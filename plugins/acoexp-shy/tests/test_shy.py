"""The contract, and what makes this strategy what it is."""

from __future__ import annotations

from acoexp_shy.shy import Shy

import acoexp
from acoexp.testing import StrategyContract, everything


class TestShy(StrategyContract):
    part = Shy(keep=0.9)


def test_an_edge_that_keeps_all_its_pheromone_is_no_different() -> None:
    plain, shy = (
        acoexp.solve("env2", "aco", seed=1, diffusion=d, ants=4, iterations=5) for d in ("none", Shy(keep=1.0))
    )
    assert everything(plain) == everything(shy).replace('"custom"', '"aco"')


def test_ants_walk_more_ways_than_without() -> None:
    plain, shy = (
        acoexp.solve_many("env2", "aco", range(20), diffusion=diffusion, ants=4, iterations=20)
        for diffusion in ("none", Shy(keep=0.5))
    )
    assert sum(map(lengths_found, plain)) < sum(map(lengths_found, shy))


def lengths_found(result: acoexp.Result) -> int:
    """Return how many lengths the best paths of a trial's cycles had."""
    return len(set(result.curve.tolist()))
