"""What a part of one's own may do in a colony, and what happens to one that breaks its contract."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np
import pytest
from numpy.typing import NDArray
from samples import as_cells, is_way, random_grid

import acoexp
from acoexp import StrategyError
from acoexp.colony.compiled import compiled
from acoexp.colony.pheromone import deposit, multiply
from acoexp.colony.problem import Problem
from acoexp.strategies import Choice, Diffusion, Heuristic, Post
from acoexp.strategies.diffusion.gaussian import Gaussian
from acoexp.strategies.update.ant_cycle import AntCycle

CORNER = {"map": [[0, 1], [0, 0]], "moves": "no_cut", "ants": 2, "iterations": 3}
"""From the upper left to the lower right it is one diagonal move, which cuts a corner and is not allowed."""


@compiled
def cut_the_corner(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    return 7


@compiled
def jump(colony: Any, own: Any, cells: Any, count: Any) -> Any:
    cells[1] = cells[count - 1]
    return 2


@compiled
def get_tired(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    own[1][0] += 1
    factor = 1.0 + own[0] / own[1][0]
    multiply(colony, cell * 8 + own[1][0] % 8, factor, factor**colony.alpha)


@compiled
def look_into_nothing(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    colony.nothing[cell] = 1.0


class CuttingCorners(Choice):
    kernel = staticmethod(cut_the_corner)


class Jumping(Post):
    kernel = staticmethod(jump)


class Tiring(Diffusion):
    """Counts its calls, and does less and less."""

    kernel = staticmethod(get_tired)

    def prepare(self, problem: Problem) -> tuple[float, NDArray[np.int64]]:
        return 500.0, np.zeros(1, dtype=np.int64)


class Faulty(Diffusion):
    kernel = staticmethod(look_into_nothing)


@dataclass(frozen=True)
class Constant(Heuristic):
    value: float

    def eta(self, problem: Problem) -> NDArray[np.float64]:
        return np.array(self.value)


@dataclass(frozen=True)
class Eastwards(AntCycle):
    """Begins with more pheromone on each move east."""

    strength: float

    def initial(self, problem: Problem) -> NDArray[np.float64]:
        return np.array([self.strength, 1, 1, 1, 1, 1, 1, 1])


def test_a_choice_of_a_move_that_is_not_allowed_is_reported() -> None:
    with pytest.raises(StrategyError, match=r"choice 'CuttingCorners' broke its contract, seed 7: .*no_cut"):
        acoexp.solve(algo="aco", seed=7, choice=CuttingCorners(), **CORNER)


def test_a_post_optimiser_that_returns_no_path_is_reported() -> None:
    with pytest.raises(StrategyError, match=r"post 'Jumping' broke its contract, seed 7, cycle 1: .* no path"):
        acoexp.solve(algo="aco", seed=7, post=Jumping(), **CORNER)


def test_what_a_part_wrote_to_its_own_state_is_forgotten_before_the_next_trial() -> None:
    grid = random_grid(6, 10, 10, "free")
    few: dict[str, Any] = {"diffusion": Tiring(), "ants": 3, "iterations": 5, "beta": 1.0}
    alone = acoexp.solve(grid, "aco", 4, **few)
    for result in acoexp.solve_many(grid, "aco", [4, 4, 4], threads=1, **few):
        assert result.curve_pairs.tolist() == alone.curve_pairs.tolist()
        assert result.ant_steps == alone.ant_steps


@pytest.mark.parametrize("value", [-1.0, np.nan, np.inf])
def test_a_heuristic_that_is_negative_or_not_finite_is_reported(value: float) -> None:
    with pytest.raises(
        StrategyError,
        match=r"heuristic 'Constant': expected eta to return numbers that are finite, and at least 0",
    ):
        acoexp.solve(algo="aco", heuristic=Constant(value), **CORNER)


@pytest.mark.parametrize("value", [0.0, 1.0, 1e300])
def test_a_heuristic_may_be_one_number_for_all_moves(value: float) -> None:
    grid = random_grid(6, 10, 10, "free")
    path = as_cells(acoexp.solve(grid, "aco", heuristic=Constant(value)).path)
    assert path is not None
    assert is_way(grid, path)


def test_an_update_may_say_what_pheromone_there_is_at_the_start() -> None:
    straight_on = {"heuristic": Constant(1.0), "ants": 1, "iterations": 1, "start": (1, 0), "goal": (1, 8)}
    result = acoexp.solve(np.zeros((3, 9)), "aco", update=Eastwards(1e9), **straight_on)
    assert as_cells(result.path) == [(1, col) for col in range(9)]


@pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")
def test_a_kernel_that_cannot_be_compiled_is_reported_with_the_parts_names() -> None:
    with pytest.raises(StrategyError, match=r"^diffusion 'Faulty' cannot be compiled: colony has no 'nothing'"):
        acoexp.solve(algo="aco", diffusion=Faulty(), **CORNER)


def test_parts_of_ones_own_make_the_algorithm_a_custom_one() -> None:
    result = acoexp.solve(np.zeros((3, 3)), "aco", update=Eastwards(1.0), ants=1, iterations=1)
    assert result.algo == "custom"


def test_a_kind_of_part_in_the_place_of_another_is_refused() -> None:
    with pytest.raises(acoexp.SettingsError, match=r"diffusion: expected .* a Diffusion object"):
        acoexp.solve(algo="aco", diffusion=Jumping(), **CORNER)


@compiled
def go_to_and_fro(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> Any:
    """Go east and back again, whatever is tabu."""
    return 0 if came == 8 or came == 4 else 4


class Restless(Choice):
    kernel = staticmethod(go_to_and_fro)


def test_a_choice_that_never_comes_to_an_end_is_reported() -> None:
    with pytest.raises(StrategyError, match=r"choice 'Restless'.* broke its contract"):
        acoexp.solve(algo="aco", choice=Restless(), **CORNER)


@pytest.mark.parametrize("gamma", [float("nan"), -1.0, 5.0, "x"])
def test_a_parameter_of_a_part_given_as_an_object_is_checked_too(gamma: Any) -> None:
    with pytest.raises(acoexp.SettingsError, match=r"diffusion.gamma: expected a number from 0 to 1"):
        acoexp.solve("fig13", "pd", diffusion=Gaussian(gamma=gamma))


def test_one_failing_trial_stops_the_others_soon() -> None:
    began = time.perf_counter()
    with pytest.raises(StrategyError, match="broke its contract"):
        acoexp.solve_many(algo="aco", choice=Restless(), seeds=range(10**5), threads=2, **CORNER)
    assert time.perf_counter() - began < 60.0, "a hundred thousand trials would take longer"


@compiled
def spoil(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    """Add an amount that is none."""
    deposit(colony, cell * 8, own[0])


@dataclass(frozen=True)
class Spoiling(Diffusion):
    amount: float

    kernel = staticmethod(spoil)

    def prepare(self, problem: Problem) -> tuple[float]:
        return (self.amount,)


@pytest.mark.parametrize("amount", [float("nan"), -100.0])
def test_pheromone_that_is_no_number_or_negative_is_reported(amount: float) -> None:
    with pytest.raises(
        StrategyError, match=r"diffusion 'Spoiling'.* broke its contract, seed 0: it made pheromone"
    ):
        acoexp.solve("fig13", "aco", diffusion=Spoiling(amount), iterations=5)
