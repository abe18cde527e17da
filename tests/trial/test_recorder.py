"""The recorder finds what a solver finds, and its tape tells how: held to the plain colony's pheromone."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import reference
from reference import Colony
from samples import everything, random_grid, settings_of

from acoexp import Grid, SettingsError
from acoexp.grid.moves import follow
from acoexp.registry.load_map import as_grid
from acoexp.registry.resolve import resolve
from acoexp.trial import recorder
from acoexp.trial.recorder import Recorder
from acoexp.trial.settings import Settings
from acoexp.trial.solver import Solver

CYCLES = 6

READINGS: list[tuple[str, dict[str, Any]]] = [
    ("pdg", {}),
    ("pd", {"pheromone": "cells", "order": "lock_step"}),
    ("pdg", {"order": "two_ended", "dead_end": "step_back"}),
    ("aco", {"dead_end": "step_back", "max_steps": 45}),
]
"""Each order, both ends of a dead end, pheromone on edges and on cells, with and without a post-optimiser."""


def settings(algo: str, reading: dict[str, Any]) -> Settings:
    return resolve(algo, {"iterations": CYCLES, **reading})


def grids() -> list[Grid]:
    return [as_grid("fig13"), random_grid(3, 9, 14, "no_cut")]


@pytest.mark.parametrize(("algo", "reading"), READINGS, ids=str)
def test_what_it_finds_is_what_a_solver_finds(algo: str, reading: dict[str, Any]) -> None:
    for grid in grids():
        solver, recording = (kind(grid, settings(algo, reading)) for kind in (Solver, Recorder))
        for seed in (0, 7):
            result, tape = recording.record(seed)
            assert everything(result) == everything(solver.solve(seed))
            assert [(row == np.inf).sum() for row in tape.walked.length] == result.lost_ants.tolist()
            assert tape.walked.ends[-1, -1] == tape.walked.moves.size


@pytest.mark.parametrize(("algo", "reading"), READINGS, ids=str)
def test_its_levels_are_a_solvers_pheromone_after_so_many_cycles(algo: str, reading: dict[str, Any]) -> None:
    for grid in grids():
        _, tape = Recorder(grid, settings(algo, reading)).record(5)
        rows, cols = grid.shape
        noted = tape.levels.reshape(-1, rows + 2, cols + 2)
        for cycles in (1, 2, CYCLES):
            solver = Solver(grid, settings(algo, {**reading, "iterations": cycles}))
            edges = [solver.pheromone(5)]
            facing = solver.room_after(5).facing
            if facing is not None:
                levels = (facing.colony.stored * facing.colony.scale[0]).reshape(rows + 2, cols + 2, 8)
                edges.append(np.where(np.isnan(edges[0]), np.nan, levels[1:-1, 1:-1]))
            assert np.array_equal(noted[cycles], np.max([into_cells(each) for each in edges], axis=0))


def into_cells(edges: Any) -> Any:
    """Return the highest level on an edge into each cell of the bordered map, move by move."""
    rows, cols, _ = edges.shape
    highest = np.zeros((rows + 2, cols + 2), dtype=np.float32)
    for (row, col, direction), level in np.ndenumerate(edges):
        down, right = reference.STEPS[direction]
        target = row + 1 + down, col + 1 + right
        highest[target] = max(highest[target], 0.0 if np.isnan(level) else np.float32(level))
    return highest


def test_a_trial_that_ends_early_has_no_more_cycles_on_its_tape() -> None:
    chosen = resolve("pdg", {"iterations": 60, "patience": 3})
    result, tape = Recorder(as_grid("fig13"), chosen).record(1)
    assert 3 < result.cycles < 60
    assert len(tape.walked.ends) == len(tape.polished.ends) == len(tape.levels) - 1 == result.cycles
    assert tape.walked.ends[-1, -1] == tape.walked.moves.size > 0


@pytest.mark.parametrize("algo", ["aco", "eas", "mmas"])
def test_before_the_first_cycle_the_levels_are_the_initial_ones(algo: str) -> None:
    grid = as_grid("fig13")
    made = Recorder(grid, resolve(algo, {"iterations": 1}))
    _, tape = made.record(0)
    first = tape.levels[0].reshape(22, 22)[1:-1, 1:-1]
    assert np.unique(first[~grid.obstacles]).tolist() == [np.float32(made._ends[0].prepared.initial[0])]
    assert not first[grid.obstacles].any()


def test_pheromone_follows_from_the_ways_on_the_tape() -> None:
    """What the plain colony lays for the ways that are on the tape are the levels that are on it."""
    grid, colony = random_grid(8, 10, 12, "no_squeeze"), Colony("aco", iterations=CYCLES)
    result, tape = Recorder(grid, resolve("aco", settings_of(colony))).record(1)
    end = reference.End(grid, colony, grid.start, grid.goal)
    found = reference.run(grid, colony, 1)
    ends = tape.walked.ends.ravel()
    ways = np.split(tape.walked.moves, ends[:-1])
    assert sum(map(len, ways)) == found.steps == result.ant_steps
    for cycle in range(CYCLES):
        paths = [
            [(row, col) for row, col in follow(grid.start, way).tolist()]
            for way in ways[cycle * colony.ants : (cycle + 1) * colony.ants]
        ]
        arrived = [path for path in paths if path[-1] == grid.goal]
        assert len(arrived) == colony.ants - found.lost[cycle]
        end.update(arrived, colony)
        levels = np.zeros(grid.shape)
        for target, level in ((end.moves[cell][d], end.tau[cell, d]) for cell, d in end.tau.place):
            levels[target] = max(levels[target], level)
        rows, cols = grid.shape
        noted = tape.levels[cycle + 1].reshape(rows + 2, cols + 2)[1:-1, 1:-1]
        assert np.allclose(noted, levels, rtol=1e-6)


def test_polished_ways_are_there_for_ants_that_arrived() -> None:
    result, tape = Recorder(as_grid("fig13"), settings("pdg", {})).record(3)
    lengths = np.diff(tape.polished.ends.ravel(), prepend=0).reshape(tape.polished.ends.shape)
    assert ((lengths == 0) == np.isinf(tape.walked.length)).all()
    assert tape.polished.length.min() == result.length
    _, unpolished = Recorder(as_grid("fig13"), settings("aco", {})).record(3)
    assert unpolished.polished.length.size == unpolished.polished.moves.size == 0


@pytest.mark.parametrize(
    ("most", "changes", "message"),
    [
        (4000, {}, r"iterations: expected at most 1 to record 10 ants on 400 cells; got 6"),
        (20_000, {"ants": 1000}, r"iterations: expected at most 1 to record 1000 ants on 400 cells; got 6"),
    ],
)
def test_too_much_to_record_is_refused_before_it_runs(
    most: int, changes: dict[str, Any], message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(recorder, "LARGEST", most)
    with pytest.raises(SettingsError, match=message):
        Recorder(as_grid("fig13"), settings("aco", changes))


def test_too_many_moves_end_the_trial_with_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    made = Recorder(as_grid("fig13"), settings("aco", {}))
    small = replace_room(made)
    monkeypatch.setattr(made, "_new_tape", small)
    with pytest.raises(SettingsError, match=r"ants: expected fewer, or fewer iterations"):
        made.record(0)


def replace_room(made: Recorder) -> Any:
    """Return what makes tapes with room for a hundred moves."""
    new_tape = made._new_tape

    def small() -> Any:
        tape = new_tape()
        return tape._replace(walked=tape.walked._replace(moves=np.zeros(100, dtype=np.uint8)))

    return small


def test_the_desirability_is_what_the_heuristic_says() -> None:
    grid = as_grid("fig13")
    beta = replace(resolve("aco", {}).scalars).beta
    desirability = Recorder(grid, settings("aco", {})).desirability
    colony = Colony("aco")
    end = reference.End(grid, colony, grid.start, grid.goal)
    assert beta == colony.beta
    for (row, col), d in end.tau.place:
        assert desirability[row, col, d] == pytest.approx(end.desire[(row, col), d])
    assert (desirability > 0).sum() == len(end.tau.place)
