"""What the colony learns: its first cycle, a colony that never learns, and the run, beside each other."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from acoexp.compare.configuration import Configuration, parse_configurations
from acoexp.compare.learning import learning_row, optimises, without_learning
from acoexp.compare.sample import Sample
from acoexp.compare.tables import learning_table

OPTIMUM = 10.0


def sample(curves: list[list[float]]) -> Sample:
    """Return trials with these best lengths by cycle; nan is a cycle in which all were lost."""
    best = np.array(curves)
    shortest = np.array([np.nan if np.isnan(curve).all() else np.nanmin(curve) for curve in best])
    steps = np.ones(best.shape, dtype=np.int64)
    return Sample("a", "yard", OPTIMUM, shortest == OPTIMUM, {"l1": shortest}, best, steps)


def configuration(text: str) -> Configuration:
    return parse_configurations([text, "eas"], {"ants": 5})[0]


def test_the_gaps_are_means_over_the_trials_that_arrived() -> None:
    learned = sample([[12.0, 10.0], [math.nan, 11.0], [14.0, 10.0], [math.nan, math.nan]])
    blind = sample([[12.0, 12.5], [13.0, 14.0], [math.nan, 11.0], [11.0, 12.0]])
    row = learning_row(learned, blind)
    assert (row["map"], row["cell"], row["trials"]) == ("yard", "a", 4)
    assert (row["first_arrived"], row["blind_arrived"], row["learned_arrived"]) == (2, 4, 3)
    gaps = (12 + 14) / 2, (12 + 13 + 11 + 11) / 4, (10 + 11 + 10) / 3
    for name, length in zip(("first", "blind", "learned"), gaps, strict=True):
        assert math.isclose(row[name], length / OPTIMUM - 1.0)


def test_where_no_trial_arrived_there_is_a_dash_and_where_some_did_their_number() -> None:
    never, always = sample([[math.nan, math.nan]] * 2), sample([[11.0, 10.0], [math.nan, 10.0]])
    table = learning_table([learning_row(always, never)])
    said: dict[str, Any] = dict(zip(table.headings, table.rows[0], strict=True))
    assert (said["cycle 1"], said["alpha = 0"], said["the run"]) == ("10.00 % (1)", "-", "0.00 %")


@pytest.mark.parametrize(
    ("text", "does"), [("aco", False), ("pdg", True), ("nav", True), ("pdg post=none", False)]
)
def test_it_is_asked_of_those_that_optimise_paths(text: str, does: bool) -> None:
    assert optimises(configuration(text)) is does


@pytest.mark.parametrize("text", ["nav", "strong: pdg alpha=3"])
def test_without_learning_a_configuration_is_the_same_but_for_alpha(text: str) -> None:
    one = configuration(text)
    blind = without_learning(one).settings
    assert blind.scalars.alpha == 0.0
    assert blind.scalars.ants == 5
    assert blind.as_dict() | {"alpha": one.settings.scalars.alpha} == one.settings.as_dict()
