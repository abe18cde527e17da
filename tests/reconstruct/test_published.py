"""What the search knows of the paper: the optima, and ten trials of standard ACO for two of the three maps."""

from __future__ import annotations

import numpy as np
import pytest

from acoexp.grid import path_length
from acoexp.reconstruct.likelihood import matches
from acoexp.reconstruct.published import ENVIRONMENTS, Environment

WITH_TRIALS = pytest.mark.parametrize("environment", [e for e in ENVIRONMENTS.values() if e.has_trials])


@pytest.mark.parametrize(("name", "optimum"), [("fig13", 30.3848), ("env1", 32.1421), ("env2", 35.0711)])
def test_an_environment_has_the_published_optimum(name: str, optimum: float) -> None:
    assert path_length(*ENVIRONMENTS[name].optimum) == pytest.approx(optimum, abs=6e-5)


@WITH_TRIALS
def test_every_published_length_is_the_optimum_or_one_of_the_local_optima(environment: Environment) -> None:
    known = np.array([path_length(*pair) for pair in (environment.optimum, *environment.local_optima)])
    printed = np.concatenate([environment.trials.l1, environment.trials.l2])
    which = matches(known, printed)
    assert (which.sum(axis=0) == 1).all()
    assert which.any(axis=1).all()


@pytest.mark.parametrize(
    ("name", "x1", "x3", "l1", "l2"),
    [("fig13", 11.0, 28.1, 30.3848, 32.7747), ("env2", 4.7, 18.0, 35.3640, 37.0427)],
)
def test_the_trials_are_those_of_standard_aco(name: str, x1: float, x3: float, l1: float, l2: float) -> None:
    """Their means are the printed ones of that algorithm, and of no other."""
    trials = ENVIRONMENTS[name].trials
    assert trials.size == 10
    assert (trials.x1.mean(), trials.x3.mean()) == (pytest.approx(x1), pytest.approx(x3))
    assert (trials.l1.mean(), trials.l2.mean()) == (pytest.approx(l1, abs=1e-4), pytest.approx(l2, abs=1e-4))


def test_no_trial_is_published_for_env1() -> None:
    assert ENVIRONMENTS["env1"].trials.size == 0
