"""What the contract's tests look at, tried out on what they should find and what they should let pass."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from acoexp import MapError
from acoexp.grid.moves import MOVE_RULES
from acoexp.registry.resolve import resolve
from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.strategies.groups import STRATEGY_GROUPS
from acoexp.strategies.part import STRATEGIES
from acoexp.testing.checks import FEW, PLAIN, check_paths, digest, group_of, laid_astray, maps
from acoexp.trial.solver import Solver


def test_there_is_a_map_with_obstacles_under_each_rule() -> None:
    assert {grid.moves for grid in maps() if grid.obstacles.any()} == set(MOVE_RULES)


def test_each_group_has_a_plain_part_to_measure_the_cost_against() -> None:
    plain = resolve("aco", PLAIN)
    assert {group: chosen.name for group, chosen in plain.chosen.items()} == PLAIN
    assert tuple(PLAIN) == STRATEGY_GROUPS


@pytest.mark.parametrize("group", STRATEGIES)
def test_a_part_is_known_by_its_kind(group: str) -> None:
    assert group_of(resolve("aco", {}).parts[group]) == group


def test_a_path_of_moves_that_are_not_allowed_is_found() -> None:
    grid = maps()[1]
    result = Solver(grid, resolve("aco", FEW)).solve(0)
    assert check_paths(grid, result)
    assert result.moves is not None
    with pytest.raises(MapError):
        check_paths(grid, replace(result, moves=result.moves[::-1].copy()))


def test_a_path_that_is_not_as_long_as_it_is_said_to_be_is_found() -> None:
    grid = maps()[0]
    result = Solver(grid, resolve("aco", FEW)).solve(0)
    with pytest.raises(AssertionError, match="a path and its length differ"):
        check_paths(grid, replace(result, curve_pairs=np.ones_like(result.curve_pairs)))


@pytest.mark.parametrize("algo", ["aco", "pd", "pdg", "pf"])
def test_no_preset_lays_pheromone_astray(algo: str) -> None:
    assert [laid_astray(Solver(grid, resolve(algo, FEW)), 0) for grid in maps()] == [[]] * len(maps())


@pytest.mark.parametrize("other", [{"part": Gaussian(gamma=0.5)}, {"algo": "pf"}, {"settings": {"ants": 3}}])
def test_the_digest_is_another_when_trials_are_others(other: dict[str, Any]) -> None:
    given: dict[str, Any] = {"part": Gaussian(), "algo": "pd", "settings": {}}
    assert digest(**given) == digest(**given) != digest(**{**given, **other})
