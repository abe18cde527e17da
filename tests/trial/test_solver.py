"""What holds for every trial: its path is a way, it depends on its seed alone, and no setting breaks it."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference import Colony, length_of, pair_of
from samples import ALGOS, as_cells, everything, grids, is_way, optimum_of, random_grid, settings_of

import acoexp
from acoexp import Grid, Result
from acoexp.colony.compiled import compiled
from acoexp.colony.random import uniform
from acoexp.registry.load_map import as_grid
from acoexp.registry.resolve import resolve
from acoexp.strategies import Diffusion
from acoexp.trial.outcome import Failure
from acoexp.trial.solver import Solver

JIT = not numba.config.DISABLE_JIT
BATCH = 12 if JIT else 3

TRAP = Grid(
    [
        [0, 0, 0, 0, 0],
        [0, 1, 1, 1, 0],
        [0, 0, 0, 1, 0],
        [0, 1, 1, 1, 0],
        [0, 0, 0, 0, 0],
    ],
    start=(2, 0),
    goal=(2, 4),
    moves="no_cut",
)
"""An ant that follows its nose walks into the dead end, and cannot turn back."""

EXTREMES: list[dict[str, Any]] = [
    {"alpha": 0.0, "beta": 0.0},
    {"alpha": 100.0},
    {"beta": 100.0},
    {"alpha": 100.0, "beta": 100.0},
    {"rho": 0.0},
    {"rho": 1.0},
    {"rho": 1.0, "alpha": 0.0},
    {"tau0": 1e100},
    {"tau0": 1e-100},
    {"tau0": 1e100, "alpha": 100.0, "beta": 100.0},
    {"tau0": 1e-100, "alpha": 100.0, "beta": 100.0},
    {"q": 1e100},
    {"q": 1e-100},
    {"q": 1e100, "rho": 0.999, "alpha": 100.0},
    {"q": 1e-100, "rho": 0.999, "alpha": 100.0},
    {"gamma": 1.0},
    {"gamma": 1.0, "rho": 0.0, "alpha": 100.0, "q": 1e100, "tau0": 1e100},
    {"at_goal": 1e300, "beta": 100.0},
]


@settings(max_examples=400 if JIT else 40, deadline=None)
@given(
    grid=grids(40 if JIT else 12),
    algo=st.sampled_from(ALGOS),
    seed=st.integers(0, 2**64 - 1),
    ants=st.integers(1, 5),
    iterations=st.integers(1, 10),
)
def test_every_path_is_a_way_and_never_beats_the_optimum(
    grid: Grid, algo: str, seed: int, ants: int, iterations: int
) -> None:
    result = acoexp.solve(grid, algo, seed, ants=ants, iterations=iterations)
    path, raw_path = as_cells(result.path), as_cells(result.raw_path)
    if path is None:
        assert result.lost_ants.tolist() == [ants] * iterations
        return
    assert is_way(grid, path)
    assert length_of(optimum_of(grid)) <= length_of(pair_of(path))
    assert min(map(length_of, result.curve_pairs[result.lost_ants < ants].tolist())) == result.length
    assert result.l1_pair == pair_of(path)
    assert (raw_path is not None) == (algo == "pdg")
    if raw_path is not None:
        assert is_way(grid, raw_path)
        assert length_of(pair_of(path)) <= length_of(pair_of(raw_path))


@pytest.mark.parametrize("algo", ALGOS)
def test_a_trial_depends_on_its_seed_alone(algo: str) -> None:
    grid, seeds = random_grid(3, 15, 18, "no_squeeze"), [*range(BATCH), 2**64 - 1]
    few: dict[str, Any] = {"ants": 4, "iterations": 15}
    single = [everything(acoexp.solve(grid, algo, seed, **few)) for seed in seeds]
    for threads in (1, 2, 5, None):
        batch = acoexp.solve_many(grid, algo, seeds, threads=threads, **few)
        assert [everything(result) for result in batch] == single
        assert [result.seed for result in batch] == seeds
    backwards = acoexp.solve_many(grid, algo, reversed(seeds), threads=2, **few)
    assert [everything(result) for result in backwards] == single[::-1]


def test_different_seeds_walk_differently() -> None:
    grid = random_grid(3, 15, 18, "no_squeeze")
    steps = {r.ant_steps for r in acoexp.solve_many(grid, "aco", range(BATCH), iterations=15)}
    assert len(steps) > BATCH / 2


@pytest.mark.parametrize("algo", ALGOS)
def test_where_no_ant_arrives_there_is_no_path_and_no_length(algo: str) -> None:
    result = acoexp.solve(TRAP, algo, seed=0, ants=3, iterations=4, beta=100.0, field={"repulsion": 0.0})
    assert result.path is None
    assert result.raw_path is None
    assert result.curve_pairs.tolist() == [[-1, -1]] * 4
    assert np.isnan(result.curve).all()
    assert result.lost_ants.tolist() == [3] * 4
    assert result.ant_steps == 3 * 4 * 2
    assert result.cycle_steps.tolist() == [3 * 2] * 4
    assert (result.x1, result.x2, result.x3) == (0, 0, 0)
    assert math.isnan(result.l1)
    assert math.isnan(result.l2)
    assert result.l1_pair is None
    assert not result.found_optimum
    assert "12 ants lost" in repr(result)


@pytest.mark.parametrize("algo", ALGOS)
def test_a_cycle_in_which_all_are_lost_has_no_length_and_the_run_may_still_have_one(algo: str) -> None:
    several = acoexp.solve_many(TRAP, algo, range(20), ants=1, iterations=10, beta=1.0)
    for result in several:
        lost = result.lost_ants == 1
        assert (np.isnan(result.curve) == lost).all()
        assert (result.path is None) == lost.all()
    assert any(0 < result.lost_ants.sum() < 10 for result in several)


@pytest.mark.parametrize("algo", ALGOS)
@pytest.mark.parametrize("extreme", EXTREMES, ids=str)
def test_extreme_settings_give_ways_and_finite_weights_without_a_warning(
    extreme: dict[str, Any], algo: str
) -> None:
    colony = Colony(algo, **{"ants": 5, "iterations": 60, **extreme})
    for grid in (random_grid(8, 6, 9, "no_squeeze"), *([as_grid("env2")] if JIT else [])):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            solver = Solver(grid, resolve(algo, settings_of(colony)))
            path, after = as_cells(solver.solve(5).path), solver.room_after(5).colony
        assert path is not None
        assert is_way(grid, path)
        assert np.isfinite(after.weight).all()
        assert (after.weight >= 0.0).all()
        assert np.isfinite(after.stored).all()


def test_the_pheromone_after_a_trial_is_what_stayed_and_what_was_laid() -> None:
    solver = Solver(
        as_grid("env2"), resolve("aco", {"ants": 1, "iterations": 1, "rho": 0.25, "tau0": 2.0, "q": 3.0})
    )
    seed = next(seed for seed in range(100) if solver.solve(seed).moves is not None)
    result = solver.solve(seed)
    expected = np.full((*solver.grid.shape, 8), np.nan)
    bits = np.unpackbits(solver.grid.allowed[..., None], axis=-1, bitorder="little").astype(bool)
    expected[bits] = 0.75 * 2.0
    for (row, col), move in zip(result.path[:-1], result.moves, strict=True):
        expected[row, col, move] += 3.0 / result.length
    np.testing.assert_allclose(solver.pheromone(seed), expected)


@pytest.mark.parametrize("algo", ALGOS)
def test_put_on_another_map_a_solver_does_what_one_made_for_it_does(algo: str) -> None:
    chosen = resolve(algo, {"ants": 4, "iterations": 10})
    first, other = random_grid(3, 9, 12, "free"), random_grid(4, 7, 20, "no_cut")
    moved, made = Solver(first, chosen).on(other), Solver(other, chosen)
    assert [everything(moved.solve(seed)) for seed in range(3)] == [
        everything(made.solve(seed)) for seed in range(3)
    ]


def test_a_solver_stays_on_its_map_when_another_is_made_from_it() -> None:
    solver = Solver(random_grid(3, 9, 12, "free"), resolve("pd", {"ants": 4, "iterations": 10}))
    before = everything(solver.solve(0))
    solver.on(random_grid(4, 7, 20, "no_cut")).solve(0)
    assert everything(solver.solve(0)) == before


def test_trials_of_one_thread_are_those_of_many() -> None:
    solver = Solver(random_grid(3, 9, 12, "free"), resolve("pd", {"ants": 4, "iterations": 10}))
    single, batch = solver.trials([5, 1, 3]), solver.solve_many([5, 1, 3], threads=2)
    assert list(map(everything, single)) == list(map(everything, batch))


def test_the_room_after_a_trial_holds_its_best_path() -> None:
    solver = Solver(as_grid("env2"), resolve("aco", {"iterations": 10}))
    best, result = solver.room_after(3).best, solver.solve(3)
    assert best.moves[0, : best.steps[0]].tolist() == result.moves.tolist()


@compiled
def stumble(colony: Any, own: Any, ant: Any, cell: Any, came: Any) -> None:
    if uniform(colony.random) < 0.004:
        raise ValueError("stumbled")


class Stumbling(Diffusion):
    """Breaks off a trial in the middle of an ant's walk, now and then."""

    kernel = staticmethod(stumble)


def test_a_trial_that_was_broken_off_leaves_nothing_to_the_next() -> None:
    chosen = resolve("aco", {"diffusion": Stumbling(), "ants": 3, "iterations": 4})
    solver = Solver(random_grid(8, 12, 16, "free"), chosen)
    outcomes: list[Result | Failure] = []
    solver.run(range(40), outcomes.append, threads=1)
    whole = [outcome for outcome in outcomes if isinstance(outcome, Result)]
    assert 5 < len(whole) < 35
    assert [everything(solver.solve(result.seed)) for result in whole] == list(map(everything, whole))


@pytest.mark.parametrize("order", ["in_turn", "lock_step"])
@pytest.mark.parametrize("patience", [1, 4, 30, 10**30])
def test_with_patience_a_trial_is_cut_after_so_many_cycles_without_better(patience: int, order: str) -> None:
    whole = acoexp.solve("env2", "aco", 3, iterations=30, order=order)
    cut = acoexp.solve("env2", "aco", 3, iterations=30, order=order, patience=patience)
    best, ends = math.inf, 30
    last_better = 0
    for cycle, length in enumerate(whole.curve.tolist(), 1):
        if length < best:
            best, last_better = length, cycle
        if cycle - last_better >= patience:
            ends = cycle
            break
    assert cut.cycles == len(cut.lost_ants) == ends
    assert cut.curve_pairs.tolist() == whole.curve_pairs[:ends].tolist()
    assert cut.lost_ants.tolist() == whole.lost_ants[:ends].tolist()
    assert cut.length == best


def test_cycles_in_which_no_ant_arrives_try_the_patience_too() -> None:
    result = acoexp.solve(TRAP, "aco", 0, iterations=50, beta=100, field={"repulsion": 0}, ants=1, patience=5)
    assert result.cycles == (5 if result.path is None else result.x1 + 5)


def test_steps_of_a_cycle_are_those_by_which_a_longer_trial_has_more() -> None:
    longer = acoexp.solve("fig13", "aco", iterations=6, ants=4)
    shorter = [acoexp.solve("fig13", "aco", iterations=cycles, ants=4).ant_steps for cycles in range(1, 7)]
    assert longer.cycle_steps.cumsum().tolist() == shorter
