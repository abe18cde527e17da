"""What a trial came to: held against the results themselves."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp import Grid, solve_many
from acoexp.registry.load_map import load_map
from acoexp.registry.resolve import resolve
from acoexp.sensitivity.outcomes import OUTCOMES, Measured
from acoexp.trial.solver import Solver
from acoexp.trial.trials import Trials

SETTINGS = resolve("aco", {"iterations": 6, "ants": 3})


def measured(grid: Grid) -> Measured:
    """Return what twenty trials on a map came to."""
    return Measured.of(Trials.of(Solver(grid, SETTINGS).solve_many(range(20))), grid, SETTINGS)


def test_outcomes_are_those_of_the_results() -> None:
    grid = load_map("env2")
    results = solve_many("env2", "aco", range(20), iterations=6, ants=3)
    one = measured(grid)
    assert list(one.outcomes) == list(OUTCOMES)
    assert one.outcomes["gap"] == pytest.approx([100.0 * (r.length / grid.optimum - 1.0) for r in results])
    assert one.outcomes["found"].tolist() == [100.0 * r.found_optimum for r in results]
    assert one.outcomes["lost"] == pytest.approx([100.0 * r.lost_ants.sum() / 18 for r in results])
    spent = [r.features.x1 if r.found_optimum else 6 for r in results]
    assert one.outcomes["cycles"].tolist() == spent
    found = sum(r.found_optimum for r in results)
    assert one.expected_cycles == (pytest.approx(sum(spent) / found) if found else np.inf)


def test_a_trial_in_which_no_ant_arrived_is_counted_and_has_the_gap_that_it_is_given() -> None:
    gap = np.array([0.0, np.nan, 5.0])
    nothing = np.zeros(3)
    one = Measured(
        {"gap": gap, "cycles": nothing + 9.0, "found": nothing, "lost": nothing}, np.zeros(3, dtype=np.bool_)
    )
    assert one.never_arrived == 1
    assert one.with_gap(7.0)["gap"].tolist() == [0.0, 7.0, 5.0]
    assert np.isnan(one.outcomes["gap"][1])
    assert one.expected_cycles == np.inf


def test_a_trial_that_patience_ended_spent_the_cycles_that_it_ran() -> None:
    grid, chosen = load_map("env2"), resolve("aco", {"iterations": 60, "ants": 3, "patience": 2})
    results = Solver(grid, chosen).solve_many(range(20))
    assert len({result.cycles for result in results}) > 1
    one = Measured.of(Trials.of(results), grid, chosen)
    assert one.outcomes["cycles"].tolist() == [r.x1 if r.found_optimum else r.cycles for r in results]
    assert one.outcomes["lost"] == pytest.approx([100.0 * r.lost_ants.sum() / (3 * r.cycles) for r in results])
