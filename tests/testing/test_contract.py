"""The contract's tests themselves: a part that breaks the contract fails the test that is there for it."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numba
import pytest
from running import install

from acoexp import SettingsError, StrategyError
from acoexp.strategies.choice.roulette import Roulette
from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.strategies.heuristic.potential_field import ForceGuided
from acoexp.strategies.post.geometric import Geometric
from acoexp.strategies.update.dual_ant_cycle import DualAntCycle
from acoexp.testing import StrategyContract

pytestmark = [
    pytest.mark.slow_without_jit,
    pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="compares with compiled kernels"),
]

PARTS = """
from dataclasses import dataclass

import numpy as np

from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import deposit, set_level
from acoexp.strategies import Choice, Diffusion


@compiled
def beyond(colony, own, ant, cell, came):
    own[0][cell] = 1.0


@compiled
def anywhere(colony, own, ant, cell, came):
    deposit(colony, cell * 8 + 3, 1e-6)


@compiled
def in_vain(colony, own, ant, cell, came):
    own[7] = 1.0


@compiled
def at_random(colony, own, ant, cell, came):
    set_level(colony, cell * 8 + 1, np.random.random())


@compiled
def wrap_around(colony, own, ant, cell, came):
    set_level(colony, cell * 8 + 1, float(own[0][0] + own[0][0]))


@dataclass(frozen=True, kw_only=True)
class Beyond(Diffusion):
    kernel = staticmethod(beyond)

    def prepare(self, problem):
        return (np.zeros(problem.grid.obstacles.size),)  # it has forgotten the border


@dataclass(frozen=True, kw_only=True)
class Anywhere(Diffusion):
    kernel = staticmethod(anywhere)


@dataclass(frozen=True, kw_only=True)
class Uncompilable(Diffusion):
    kernel = staticmethod(in_vain)


@dataclass(frozen=True, kw_only=True)
class Undeclared(Diffusion):
    share: float = 0.5

    kernel = staticmethod(anywhere)


@dataclass(frozen=True, kw_only=True)
class Random(Diffusion):
    kernel = staticmethod(at_random)


@compiled
def to_and_fro(colony, own, ant, cell, came):
    for direction in range(8):
        if colony.allowed[cell] >> direction & 1 and direction != came:
            return direction
    return came


@dataclass(frozen=True, kw_only=True)
class Wandering(Choice):
    kernel = staticmethod(to_and_fro)


@dataclass(frozen=True, kw_only=True)
class Wrapping(Diffusion):
    kernel = staticmethod(wrap_around)

    def prepare(self, problem):
        return (np.full(1, 200, dtype=np.uint8),)
"""


@pytest.fixture
def contract_of(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """Return a function that makes the tests of a faulty part."""
    install(tmp_path, "faulty-diffusions", "", {"faulty_diffusions.py": PARTS})
    monkeypatch.syspath_prepend(tmp_path)
    module = import_module("faulty_diffusions")

    def make(name: str) -> StrategyContract:
        tests: StrategyContract = type("Tests", (StrategyContract,), {"part": getattr(module, name)()})()
        return tests

    yield make
    del sys.modules["faulty_diffusions"]


def test_an_index_out_of_bounds_is_found(contract_of: Any) -> None:
    tests = contract_of("Beyond")
    with pytest.raises(AssertionError) as caught:
        tests.test_nothing_is_read_or_written_out_of_bounds()
    (message, *_) = str(caught.value).splitlines()
    assert message.startswith("under NUMBA_BOUNDSCHECK=1 NUMBA_DISABLE_JIT=0: a kernel of the colony ")
    assert message.endswith("IndexError: index is out of bounds; most likely diffusion 'Beyond'")
    for other in (tests.test_it_compiles_and_finds_valid_paths, tests.test_a_trial_depends_on_its_seed_alone):
        with pytest.raises(pytest.skip.Exception, match="out of bounds"):
            other()


def test_pheromone_that_is_laid_where_no_ant_may_go_is_found(contract_of: Any) -> None:
    with pytest.raises(AssertionError, match=r"moves that are not allowed, such as direction 3 from \(\d+, \d+\)"):
        contract_of("Anywhere").test_pheromone_is_laid_on_allowed_moves_alone()


def test_an_ant_that_goes_where_it_has_been_is_found(contract_of: Any) -> None:
    with pytest.raises(AssertionError, match=r"an ant went to \(\d+, \d+\) twice; expected colony.untouched"):
        contract_of("Wandering").test_no_ant_goes_where_it_has_been()


def test_a_part_that_does_not_compile_fails_one_test_alone(contract_of: Any) -> None:
    tests = contract_of("Uncompilable")
    with pytest.raises(StrategyError, match="diffusion 'Uncompilable' cannot be compiled: "):
        tests.test_it_compiles_and_finds_valid_paths()
    others = (
        tests.test_a_trial_depends_on_its_seed_alone,
        tests.test_pheromone_is_laid_on_allowed_moves_alone,
        tests.test_no_ant_goes_where_it_has_been,
        tests.test_nothing_is_read_or_written_out_of_bounds,
        tests.test_without_the_compiler_it_does_the_same,
        lambda: tests.test_cost_per_ant_step(print),
    )
    for other in others:
        with pytest.raises(pytest.skip.Exception):
            other()


def test_a_field_that_is_no_parameter_is_found(contract_of: Any) -> None:
    with pytest.raises(SettingsError, match=r"share is a field without parameter\(\)"):
        contract_of("Undeclared").test_it_compiles_and_finds_valid_paths()


def test_random_numbers_of_its_own_are_found(contract_of: Any) -> None:
    with pytest.raises(AssertionError, match="other results than one by one"):
        contract_of("Random").test_a_trial_depends_on_its_seed_alone()


def test_arithmetic_that_the_compiler_does_in_another_way_is_found(contract_of: Any) -> None:
    with pytest.raises(AssertionError):
        contract_of("Wrapping").test_without_the_compiler_it_does_the_same()


def test_a_part_that_no_other_process_can_import_is_told_of() -> None:
    class Local(Gaussian):
        pass

    tests = StrategyContract()
    tests.part = Local()  # type: ignore[misc]
    with pytest.raises(AssertionError, match="where it can be imported"):
        tests.test_without_the_compiler_it_does_the_same()


@pytest.mark.parametrize("part", [ForceGuided(), Roulette(), Gaussian(), Geometric(), DualAntCycle()])
def test_a_part_of_each_group_passes(part: Any, capsys: pytest.CaptureFixture[str]) -> None:
    tests, noted = StrategyContract(), {}
    tests.part = part  # type: ignore[misc]
    tests.test_it_compiles_and_finds_valid_paths()
    tests.test_a_trial_depends_on_its_seed_alone()
    tests.test_pheromone_is_laid_on_allowed_moves_alone()
    tests.test_no_ant_goes_where_it_has_been()
    tests.test_without_the_compiler_it_does_the_same()
    tests.test_cost_per_ant_step(noted.__setitem__)
    assert noted["ratio_to_plain"] > 0.1
    assert f"{type(part).__name__}: " in capsys.readouterr().out


def test_a_broken_contract_fails_the_first_test() -> None:
    class Lost(Gaussian):
        def prepare(self, problem: Any) -> Any:
            raise ZeroDivisionError

    tests = StrategyContract()
    tests.part = Lost()  # type: ignore[misc]
    with pytest.raises(StrategyError, match="failed in prepare"):
        tests.test_it_compiles_and_finds_valid_paths()
