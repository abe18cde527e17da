"""The update rules of EAS, AS_rank, MAX-MIN and ACS, each held to its defining property by hand on a 3 x 3 map."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from samples import colony_on, drawn, number_of, problem_on, random_grid, trails_of

import acoexp
from acoexp.colony.pheromone import level, refresh
from acoexp.colony.state import Colony
from acoexp.strategies.update.elitist import Elitist
from acoexp.strategies.update.global_best import GlobalBest
from acoexp.strategies.update.max_min import CHOICES, MaxMin
from acoexp.strategies.update.rank_based import RankBased

E, NE, N, NW, W, SW, S, SE = range(8)

GRID, _ = drawn("a.. ... ..b")
LONG, SHORT, BENT = [E, E, S, S], [SE, SE], [E, SE, S]
LENGTH = {"LONG": 4.0, "SHORT": 2.0 * math.sqrt(2.0), "BENT": 2.0 + math.sqrt(2.0)}
RHO, Q, TAU0 = 0.25, 6.0, 2.0


def updated(rule: Any, *walks: list[int] | None, best: list[int] | None, rho: float = RHO) -> Colony:
    """Return a colony after one update with these ants' ways and this best way so far; None is a lost ant."""
    problem = problem_on(GRID, ants=len(walks), rho=rho, q=Q, tau0=TAU0, alpha=1.0)
    colony = colony_on(problem)
    trails, best_trails = trails_of(colony, *walks), trails_of(colony, best, best)
    rule.kernel(colony, rule.prepare(problem), trails, trails, best_trails)
    refresh(colony)
    return colony


def level_at(colony: Colony, cell: tuple[int, int], direction: int) -> float:
    return float(level(colony, number_of(problem_on(GRID), cell) * 8 + direction))


def test_elitist_ants_walk_the_best_path_again() -> None:
    colony = updated(Elitist(elitists=3), LONG, None, best=SHORT)
    assert math.isclose(level_at(colony, (0, 0), E), 1.5 + Q / LENGTH["LONG"])
    assert math.isclose(level_at(colony, (0, 0), SE), 1.5 + 3 * Q / LENGTH["SHORT"])


def test_without_elitists_it_is_the_ant_system() -> None:
    colony = updated(Elitist(elitists=0), LONG, best=SHORT)
    assert level_at(colony, (0, 0), SE) == 1.5


def test_ants_lay_by_rank_and_the_best_path_gets_most() -> None:
    colony = updated(RankBased(ranks=3), LONG, BENT, None, BENT, best=SHORT)
    assert math.isclose(level_at(colony, (0, 0), E), 1.5 + (2 + 1) * Q / LENGTH["BENT"])
    assert level_at(colony, (0, 1), E) == 1.5, "the longest of three has no rank left"
    assert math.isclose(level_at(colony, (0, 0), SE), 1.5 + 3 * Q / LENGTH["SHORT"])


def test_only_so_many_ants_lay_as_there_are_ranks() -> None:
    colony = updated(RankBased(ranks=1), LONG, BENT, best=SHORT)
    assert level_at(colony, (0, 0), E) == 1.5


@pytest.mark.parametrize("whose", ["cycle", "run"])
def test_only_one_path_gets_pheromone_in_max_min(whose: str) -> None:
    colony = updated(MaxMin(p_best=0.9, best=whose), LONG, BENT, best=SHORT)
    edge, laid = {"cycle": (E, Q / LENGTH["BENT"]), "run": (SE, Q / LENGTH["SHORT"])}[whose]
    assert math.isclose(level_at(colony, (0, 0), edge), 1.5 + laid)
    assert math.isclose(level_at(colony, (0, 0), E + SE - edge), 1.5)
    assert math.isclose(level_at(colony, (0, 1), E), 1.5), "the longer ant lays nothing"


@pytest.mark.parametrize("rho", [0.02, 0.25, 0.9])
def test_max_min_keeps_every_level_between_limits_that_follow_from_the_best_path(rho: float) -> None:
    colony = updated(MaxMin(p_best=0.05), SHORT, best=SHORT, rho=rho)
    highest = Q / (rho * LENGTH["SHORT"])
    root = 0.05 ** (1 / 2)
    lowest = min(highest, highest * (1 - root) / ((CHOICES - 1) * root))
    levels = [level_at(colony, (r, c), d) for r in range(3) for c in range(3) for d in range(8)]
    assert min(levels) >= lowest * (1 - 1e-12)
    assert max(levels) <= highest * (1 + 1e-12)


def test_max_min_begins_at_a_level_that_no_limit_exceeds() -> None:
    grid = random_grid(3, 12, 12, "no_squeeze")
    problem = problem_on(grid, rho=0.1, q=2.0)
    assert MaxMin().initial(problem) >= 2.0 / (0.1 * grid.optimum)


def test_only_the_best_paths_edges_change_in_acs() -> None:
    colony = updated(GlobalBest(), LONG, BENT, best=SHORT)
    assert math.isclose(level_at(colony, (0, 0), SE), 0.75 * TAU0 + 0.25 * Q / LENGTH["SHORT"])
    assert level_at(colony, (0, 0), E) == TAU0


@pytest.mark.parametrize("rule", [Elitist(), RankBased(), MaxMin(best="run"), GlobalBest()])
def test_as_long_as_no_ant_has_arrived_nothing_is_laid(rule: Any) -> None:
    colony = updated(rule, None, None, best=None)
    levels = {level_at(colony, (r, c), d) for r in range(3) for c in range(3) for d in range(8)}
    assert len(levels) == 1


@pytest.mark.parametrize("algo", ["eas", "rank", "mmas", "acs"])
def test_a_preset_finds_short_paths(algo: str) -> None:
    """Not how good it is, but that it learns: what it converges to is better than what its first cycles find."""
    results = acoexp.solve_many("fig13", algo, range(20), iterations=100)
    assert np.nanmean([r.curve[-10:] for r in results]) < np.nanmean([r.curve[:3] for r in results])
    assert {result.algo for result in results} == {algo}
