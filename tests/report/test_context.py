"""What a report is given: in what the command line differs from its preset, and a way to run trials."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from acoexp import Grid
from acoexp.registry.resolve import resolve
from acoexp.report.context import Context
from acoexp.trial.seeds import parse_seeds

YARD = Grid([[0, 0], [0, 0]], name="yard")
SEEDS = parse_seeds("0-9")


def context(algo: str = "pdg", values: dict[str, Any] | None = None, **given: Any) -> Context:
    """Return the context of a command line that says these values."""
    return Context(
        algo=algo,
        preset=resolve(algo, {}),
        settings=resolve(algo, values or {}),
        grid=YARD,
        folder=Path("report"),
        **{"trials_of": lambda settings, grid, seeds, show: None, **given},
    )


@pytest.mark.parametrize(
    ("values", "own"),
    [
        ({}, {}),
        ({"rho": 0.5, "ants": 10}, {}),
        ({"rho": 0.25, "ants": 3}, {"rho": 0.25, "ants": 3}),
        ({"field": {"reach": 4.0}}, {}),
        ({"field": {"reach": 3.0}, "q": 2.0}, {"q": 2.0, "field": {"reach": 3.0}}),
        ({"diffusion": {"gamma": 0.5}}, {}),
    ],
)
def test_own_settings_are_those_in_which_the_command_line_differs_from_its_preset(
    values: dict[str, Any], own: dict[str, Any]
) -> None:
    assert context(values=values).own_settings == own


def test_what_a_preset_sets_is_nobodys_own() -> None:
    assert context("mmas").own_settings == {}
    assert context("mmas", {"rho": resolve("aco", {}).scalars.rho}).own_settings == {"rho": 0.5}


@pytest.mark.parametrize(
    ("values", "own"),
    [
        ({}, []),
        ({"post": "geometric", "diffusion": {"gamma": 0.01}}, []),
        ({"diffusion": {"gamma": 0.5}}, ["diffusion"]),
        ({"post": "none", "heuristic": "potential_field"}, ["heuristic", "post"]),
    ],
)
def test_own_parts_are_the_groups_whose_part_or_parameter_differs(values: dict[str, Any], own: list[str]) -> None:
    assert context(values=values).own_parts == own


@pytest.mark.parametrize(("named", "shown_as"), [("aco on yard", "aco on yard"), ("", "aco")])
def test_trials_are_run_by_whoever_keeps_them_and_shown_by_name_while_they_run(named: str, shown_as: str) -> None:
    asked: list[Any] = []
    shown: list[tuple[str, int]] = []

    def trials_of(settings: Any, grid: Any, seeds: Any, show: Any) -> str:
        asked.append((settings, grid, seeds))
        show(7)
        return "the trials"

    settings = resolve("aco", {})
    made = context(trials_of=trials_of, show=lambda name, done: shown.append((name, done)))
    assert made.run(settings, YARD, SEEDS, named) == "the trials"
    assert asked == [(settings, YARD, SEEDS)]
    assert shown == [(shown_as, 7)]
