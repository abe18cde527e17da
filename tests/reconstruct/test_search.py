"""The search: the same seed finds the same map, with the optimum that is wanted, and never sees a fresh seed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
import pytest

from acoexp import Grid, Result
from acoexp.reconstruct import search as module
from acoexp.reconstruct.calibration import standard_aco
from acoexp.reconstruct.layout import Layout, paint
from acoexp.reconstruct.published import ENVIRONMENTS, RULES
from acoexp.reconstruct.search import FRESH_BELOW, SEARCH_CYCLES, Search
from acoexp.trial.solver import Solver

pytestmark = pytest.mark.slow_without_jit


@pytest.fixture(autouse=True)
def _small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_STARTS", 8)
    monkeypatch.setattr(module, "_MOST_TRIALS", 32)


def found(name: str, seed: int, moves: str | None = None, steps: int = 12) -> Layout:
    """Search for so many steps."""
    return Search(ENVIRONMENTS[name], seed, moves, standard_aco(SEARCH_CYCLES)).run(steps, lambda: None)


@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_the_same_seed_finds_the_same_map_and_another_seed_another(name: str) -> None:
    first, again, other = found(name, 0), found(name, 0), found(name, 1)
    assert (first == again).all()
    assert not np.array_equal(first, other)


@pytest.mark.parametrize("name", ENVIRONMENTS)
@pytest.mark.parametrize("moves", RULES)
def test_a_map_has_exactly_the_published_optimum(name: str, moves: str) -> None:
    grid = Grid(paint(found(name, 3, moves, steps=3)), moves=moves)
    assert grid.optimum_pair == ENVIRONMENTS[name].optimum


def test_runs_take_turns_in_the_rule_if_none_is_given() -> None:
    aco = standard_aco(SEARCH_CYCLES)
    assert {Search(ENVIRONMENTS["env1"], seed, None, aco).moves for seed in range(3)} == set(RULES)


def test_the_search_never_sees_a_fresh_seed_nor_any_seed_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[int] = []
    trials = Solver.trials

    def watched(self: Solver, seeds: Iterable[int]) -> Iterator[Result]:
        seen.extend(seeds)
        return trials(self, seeds)

    monkeypatch.setattr(Solver, "trials", watched)
    found("fig13", 0)
    assert min(seen) >= FRESH_BELOW
    assert len(set(seen)) == len(seen)
