"""A study: which configurations run with which seeds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from acoexp import Grid, SettingsError
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.sensitivity.factors import parse_factors
from acoexp.sensitivity.study import Findings, Study
from acoexp.trial.trials import Trials

SETTINGS = resolve("aco", {"iterations": 4, "ants": 2})
YARD = Grid([[0, 0], [0, 0]], name="yard")  # whose optimum is one diagonal move


def study(*texts: str, points: int = 8, replicates: int = 2, trials: int = 3) -> Study:
    return Study(parse_factors(texts, "aco", SETTINGS), points, replicates, trials)


def context(trials_of: Any) -> Context:
    preset = resolve("aco", {})
    return Context(
        algo="aco", preset=preset, settings=SETTINGS, grid=YARD, folder=Path("report"), trials_of=trials_of
    )


def trials(seeds: Any, arrives: bool = True) -> Trials:
    """Return trials that find the optimum at once, or in which no ant arrives."""
    n = len(seeds)
    pairs = np.full((n, 4, 2), -1) if not arrives else np.tile([0, 1], (n, 4, 1))
    lost, steps = np.zeros((2, n, 4), dtype=np.int64)
    return Trials(seeds.array(), pairs, lost, steps, np.full(n, 4, np.int32), np.zeros((n, 5)))


def test_curves_share_their_seeds_and_each_point_of_the_design_has_its_own() -> None:
    asked: list[tuple[float, str]] = []

    def trials_of(settings: Any, grid: Any, seeds: Any, show: Any) -> Trials:
        asked.append((settings.scalars.rho, str(seeds)))
        return trials(seeds)

    one = study("rho=choice(0.25,0.75)", "alpha=choice(1,2)", points=8, replicates=2)
    found = one.run(context(trials_of))
    curves, design = asked[: len(one.levels)], asked[len(one.levels) :]
    assert [rho for rho, _ in curves] == [0.25, 0.5, 0.75, 0.5, 0.5, 0.5]  # of rho; then of alpha, 1.1 among them
    assert {seeds for _, seeds in curves} == {"0-2"}
    assert [seeds for _, seeds in design] == [f"{3 + 2 * place}-{4 + 2 * place}" for place in range(4 * 8)]
    assert (len(found.curves), len(found.design)) == (len(curves), len(design))
    assert one.configurations == len(asked)
    assert one.size == sum(len(m.found) for m in (*found.curves, *found.design))


def test_what_no_configuration_may_have_together_is_refused_before_any_trial(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refuse(settings: Any, algo: str, values: Any) -> Any:
        if len(values) == 2:
            raise SettingsError("not together")
        return settings

    one = study("rho", "alpha")
    monkeypatch.setattr("acoexp.sensitivity.study.settings_with", refuse)
    with pytest.raises(SettingsError, match="not together"):
        one.run(context(None))


def test_trials_in_which_no_ant_arrives_are_counted_and_have_the_largest_gap() -> None:
    def trials_of(settings: Any, grid: Any, seeds: Any, show: Any) -> Trials:
        return trials(seeds, arrives=settings.scalars.rho < 0.5)

    found: Findings = study("rho=choice(0.25,0.75)").run(context(trials_of))
    assert found.never_arrived == 2 * 3 + sum(p["rho"] > 0.5 for p in found.study.design) * 2
    assert found.worst_gap == 0.0
    assert found.shares["gap"] is None  # all that is known of it is the same
    assert found.shares["cycles"] is not None
    assert found.shares["cycles"].alone[0].value == pytest.approx(1.0, abs=0.2)


def test_where_no_ant_ever_arrives_there_is_no_gap() -> None:
    found = study("rho").run(context(lambda settings, grid, seeds, show: trials(seeds, arrives=False)))
    assert found.worst_gap == 0.0
    assert set(found.shares.values()) == {None}
