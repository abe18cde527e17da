"""The colony's scalars: the paper's values, and what is no value."""

from __future__ import annotations

from typing import Any

import pytest

from acoexp import SettingsError
from acoexp.colony.scalars import ColonySettings
from acoexp.parameters import build

PAPER = {"alpha": 1.1, "beta": 12.0, "rho": 0.5, "ants": 10, "iterations": 200}
"""Liu et al. 2017, Sect. 5."""


@pytest.mark.parametrize(("key", "value"), PAPER.items())
def test_what_the_paper_gives_is_the_default(key: str, value: float) -> None:
    assert getattr(ColonySettings(), key) == value


@pytest.mark.parametrize("rho", [0.0, 1.0])
def test_nothing_or_all_may_evaporate(rho: float) -> None:
    assert build(ColonySettings, {"rho": rho}).rho == rho


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("rho", 1.01),
        ("alpha", -0.1),
        ("ants", 0),
        ("iterations", 0),
        ("q", 0.0),
        ("tau0", 0.0),
        ("pheromone", "corners"),
        ("order", "at_random"),
    ],
)
def test_what_no_colony_can_have_is_refused(key: str, value: Any) -> None:
    with pytest.raises(SettingsError, match=f"^{key}: expected "):
        build(ColonySettings, {key: value})
